-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Deep comparison: where two values differ, one line each, with the way to the place in front.
local pretty = require "meander.pretty"

local difference = {}

local limits = { lines = 10, depth = 100 }

local function key_text(key)
  if type(key) == "string" and key:match("^[%a_][%w_]*$") then return "." .. key end
  return "[" .. pretty.text(key) .. "]"
end

-- nan is what is expected where nan is expected.
local function same_leaf(expected, actual)
  return expected == actual or (expected ~= expected and actual ~= actual)
end

-- A view of native numbers as a plain list, anything else as it is.
function difference.plain(value)
  if type(value) ~= "userdata" then return value end
  local ok, list = pcall(function() return value:totable() end)
  return ok and list or value
end

local function mismatch(expected, actual)
  return ("expected %s, got %s"):format(pretty.text(expected), pretty.text(actual))
end

local function before(a, b)
  if type(a) == type(b) and (type(a) == "number" or type(a) == "string") then return a < b end
  return type(a) .. tostring(a) < type(b) .. tostring(b)
end

local function keys_of_both(expected, actual)
  local keys = {}
  for key in next, expected do keys[#keys + 1] = key end
  for key in next, actual do
    if rawget(expected, key) == nil then keys[#keys + 1] = key end
  end
  table.sort(keys, before)
  return keys
end

local function compare(expected, actual, path, lines, seen, depth)
  if same_leaf(expected, actual) or #lines > limits.lines then return end
  if type(expected) ~= "table" or type(actual) ~= "table" or depth >= limits.depth then
    lines[#lines + 1] = (path == "" and "" or path .. ": ") .. mismatch(expected, actual)
    return
  end
  if seen[expected] == actual then return end  -- the same ring in both
  seen[expected] = actual
  for _, key in ipairs(keys_of_both(expected, actual)) do
    compare(rawget(expected, key), rawget(actual, key), path .. key_text(key), lines, seen, depth + 1)
  end
end

-- Lines where `actual` is not what was expected; none when they are equal.
function difference.lines(expected, actual)
  if type(expected) == "table" then actual = difference.plain(actual) end
  local lines = {}
  compare(expected, actual, "", lines, {}, 0)
  if #lines > limits.lines then lines[#lines] = "..." end
  return lines
end

return difference

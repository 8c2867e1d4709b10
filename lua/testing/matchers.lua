-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Matchers about values of any kind.
local difference = require "meander.testing.difference"
local expect = require "meander.testing.expect"
local kind_of = meander.kind
local pretty = require "meander.pretty"

local matcher = expect.matcher

local wrong_use = expect.raise

local function got(value, wanted) return ("expected %s, got %s"):format(wanted, pretty.text(value)) end

-- Worlds tell by themselves how they differ.
local function world_lines(expected, actual)
  local ok, lines = pcall(function() return actual:diff(expected) end)
  return ok and type(lines) == "table" and lines or {}
end

matcher("equals", function(value, expected)
  local lines = difference.lines(expected, value)
  if #lines == 0 then return true end
  if type(value) == "userdata" and type(expected) == "userdata" then
    local changes = world_lines(expected, value)
    if #changes > 0 then return false, "differs:\n" .. table.concat(changes, "\n") end
  end
  if #lines == 1 then return false, lines[1] end
  return false, "differs in:\n" .. table.concat(lines, "\n")
end)

matcher("is", function(value, expected)
  local alike = not rawequal(value, expected) and #difference.lines(expected, value) == 0
  return rawequal(value, expected),
    got(value, pretty.text(expected)) .. (alike and type(value) == "table" and ", an equal one but not the same" or "")
end)

for name, wanted in pairs { is_true = true, is_false = false } do
  matcher(name, function(value) return value == wanted, got(value, tostring(wanted)) end)
end
matcher("is_nil", function(value) return value == nil, got(value, "nil") end)
matcher("exists", function(value) return value ~= nil, got(value, "something") end)
matcher("is_truthy", function(value) return not not value, got(value, "neither nil nor false") end)
matcher("is_falsy", function(value) return not value, got(value, "nil or false") end)

matcher("is_a", function(value, kind)
  return type(value) == kind or math.type(value) == kind or kind_of(value) == kind, got(value, "a " .. tostring(kind))
end)

local function compared(name, words, holds)
  matcher(name, function(value, bound)
    if type(bound) ~= "number" and type(bound) ~= "string" then
      wrong_use(("%s: a number or text expected, got %s"):format(name, pretty.text(bound)))
    end
    return type(value) == type(bound) and holds(value, bound), got(value, words .. " " .. pretty.text(bound))
  end)
end
compared("less_than", "less than", function(a, b) return a < b end)
compared("greater_than", "greater than", function(a, b) return a > b end)
compared("at_most", "at most", function(a, b) return a <= b end)
compared("at_least", "at least", function(a, b) return a >= b end)

matcher("between", function(value, low, high)
  if type(low) ~= "number" or type(high) ~= "number" then wrong_use "between: two numbers expected" end
  return type(value) == "number" and value >= low and value <= high,
    got(value, ("a number from %s to %s"):format(pretty.text(low), pretty.text(high)))
end)

-- The places where numbers are further apart than the tolerance; tables and views by their keys in `expected`.
local function far(expected, value, tolerance, path, lines)
  if type(expected) == "number" then
    local off = type(value) == "number" and math.abs(value - expected) or nil
    if value == expected or (off and off <= tolerance) then return end
    lines[#lines + 1] = ("%s%s"):format(path == "" and "" or path .. ": ",
      got(value, ("%s +- %s"):format(pretty.text(expected), pretty.text(tolerance)))
        .. (off and (", off by %.6g"):format(off) or ""))
    return
  end
  for key, part in pairs(expected) do
    local ok, other = pcall(function() return value[key] end)
    far(part, ok and other or nil, tolerance, ("%s[%s]"):format(path, pretty.text(key)), lines)
  end
end

matcher("near", function(value, expected, tolerance)
  tolerance = tolerance or 1e-9
  expected = difference.plain(expected)
  if type(expected) ~= "number" and type(expected) ~= "table" or type(tolerance) ~= "number" then
    wrong_use "near: a number or table of numbers expected, then a tolerance"
  end
  local lines = {}
  far(expected, difference.plain(value), tolerance, "", lines)
  table.sort(lines)
  return #lines == 0, table.concat(lines, "\n")
end)

local function length_of(value)
  local ok, length = pcall(function() return #value end)
  return ok and length or nil
end
matcher("has_length", function(value, length)
  return length_of(value) == length, ("expected length %s, got %s"):format(pretty.text(length), pretty.text(length_of(value)))
end)
matcher("is_empty", function(value)
  local empty = value == "" or (type(value) == "table" and next(value) == nil) or (type(value) == "userdata" and length_of(value) == 0)
  return empty, got(value, "something empty")
end)

matcher("contains", function(value, part)
  if type(value) == "string" then
    return type(part) == "string" and value:find(part, 1, true) ~= nil, got(value, "a text that contains " .. pretty.text(part))
  end
  local list = difference.plain(value)
  if type(list) == "table" then
    for _, element in pairs(list) do
      if #difference.lines(part, element) == 0 then return true end
    end
  end
  return false, got(value, "something that contains " .. pretty.text(part))
end)

matcher("matches", function(value, pattern)
  if type(pattern) ~= "string" then wrong_use("matches: a Lua pattern expected, got " .. pretty.text(pattern)) end
  return type(value) == "string" and value:find(pattern) ~= nil, got(value, "a text that matches " .. pretty.text(pattern))
end)

-- A pattern, or the text as it stands.
local function fits(text, wanted) return text:find(wanted, 1, true) or (pcall(string.find, text, wanted) and text:find(wanted)) end

matcher("throws", function(value, wanted)
  if type(value) ~= "function" then
    wrong_use("throws: expect(function() ... end) needed, got " .. pretty.text(value))
  end
  local ok, problem = pcall(value)
  if ok then return false, "expected an error" .. (wanted and " with " .. pretty.text(wanted) or "") .. ", got none" end
  if wanted == nil then return true end
  if type(wanted) ~= "string" then return #difference.lines(wanted, problem) == 0, got(problem, pretty.text(wanted)) end
  return not not fits(tostring(problem), wanted), got(problem, "an error with " .. pretty.text(wanted))
end)

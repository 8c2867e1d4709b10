-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- One-line JSON of plain Lua values. Keys come out in the order given, or sorted; same value, same text.
local json = {}

local escapes = { ['"'] = '\\"', ["\\"] = "\\\\", ["\n"] = "\\n", ["\r"] = "\\r", ["\t"] = "\\t" }

local function quoted(text)
  return '"' .. text:gsub('[%c"\\\127]', function(c) return escapes[c] or ("\\u%04x"):format(c:byte()) end) .. '"'
end

local function number(value)
  if value ~= value or value == math.huge or value == -math.huge then return "null" end
  if math.type(value) == "integer" then return ("%d"):format(value) end
  local short = ("%.15g"):format(value)
  return tonumber(short) == value and short or ("%.17g"):format(value)
end

local function sorted_keys(t)
  local keys = {}
  for key in pairs(t) do
    if type(key) ~= "string" then error("json.encode: table with a key of type " .. type(key) .. "; strings or 1..n expected", 0) end
    keys[#keys + 1] = key
  end
  table.sort(keys)
  return keys
end

local encode

local function list(t, depth)
  local parts, size = {}, #t
  for key in pairs(t) do
    if math.type(key) ~= "integer" or key < 1 or key > size then
      error("json.encode: list with a key '" .. tostring(key) .. "'; only 1..n or only strings expected", 0)
    end
  end
  for i = 1, size do parts[i] = encode(t[i], nil, depth) end
  return "[" .. table.concat(parts, ",") .. "]"
end

local function object(t, order, depth)
  local parts = {}
  for _, key in ipairs(order or sorted_keys(t)) do
    if t[key] ~= nil then parts[#parts + 1] = quoted(key) .. ":" .. encode(t[key], nil, depth) end
  end
  return "{" .. table.concat(parts, ",") .. "}"
end

encode = function(value, order, depth)
  depth = (depth or 0) + 1
  if depth > 100 then error("json.encode: nested more than 100 deep, or a table that contains itself", 0) end
  local kind = type(value)
  if kind == "nil" then return "null" end
  if kind == "boolean" then return tostring(value) end
  if kind == "number" then return number(value) end
  if kind == "string" then return quoted(value) end
  if kind ~= "table" then error("json.encode: nil, boolean, number, string or table expected, got " .. kind, 0) end
  if #value > 0 or (next(value) == nil and not order) then return list(value, depth) end
  return object(value, order, depth)
end

--- The value as one line of JSON. `order` (optional) names the keys of an object in the order wanted; others are left out.
--- nan and infinity become null.
function json.encode(value, order) return encode(value, order) end

return json

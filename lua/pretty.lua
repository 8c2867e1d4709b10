-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Values as text for people: what the prompt echoes. Tables are shown with limits on depth, number of items and width,
-- and keys in a fixed order; a table inside itself is named, not followed.
local pretty = {}

-- A script may take away what it does not use itself.
local getmetatable, ipairs, math, next, rawget, rawlen = getmetatable, ipairs, math, next, rawget, rawlen
local table, tostring, type, utf8, debug = table, tostring, type, utf8, debug

local limits = { depth = 4, items = 40, width = 80, row = 10, text = 200 }

local keywords = {}
for word in ("and break do else elseif end false for function goto if in local nil not or repeat return then true until while")
    :gmatch("%a+") do
  keywords[word] = true
end

local escapes = { ["\n"] = "\\n", ["\t"] = "\\t", ["\r"] = "\\r", ["\\"] = "\\\\", ['"'] = '\\"' }

local function numbered(bytes)
  return (bytes:gsub(".", function(c) return ("\\%03d"):format(c:byte()) end))
end

-- What a terminal could take for a command is written as Lua escapes: control characters but line end and tab, those
-- of two bytes as well, and every high byte of a text that is not UTF-8.
local function harmless(text)
  if not utf8.len(text) then text = text:gsub("[\128-\255]", numbered) end
  return (text:gsub("[\0-\8\11-\31\127]", numbered):gsub("\194[\128-\159]", numbered))
end

-- The first bytes of a text, up to the end of a character.
local function beginning(text, most)
  while most > 0 and (text:byte(most + 1) or 0) & 0xc0 == 0x80 do most = most - 1 end
  return text:sub(1, most)
end

local function quoted(text)
  local shown = #text > limits.text and beginning(text, limits.text) or text
  shown = harmless(shown:gsub('[\n\t\r\\"]', escapes))
  return '"' .. shown .. '"' .. (#text > limits.text and ("... (%d bytes)"):format(#text) or "")
end

-- Numbers, then texts, then the rest, so that the same table always reads the same.
local function before(a, b)
  local ta, tb = math.type(a) and "" or type(a), math.type(b) and "" or type(b)
  if ta ~= tb then return ta < tb end
  if ta == "" or ta == "string" then return a < b end
  return tostring(a) < tostring(b)
end

local function sorted_keys(t, length)
  local keys = {}
  for key in next, t do
    if not (math.type(key) == "integer" and key >= 1 and key <= length) then keys[#keys + 1] = key end
  end
  table.sort(keys, before)
  return keys
end

-- Where it was written; an address would tell nobody anything.
local function function_text(value)
  local source = debug.getinfo(value, "S")
  if source.what == "C" then return "function" end
  return ("function of %s:%d"):format(source.short_src, source.linedefined)
end

local show

local function key_text(key, state)
  if type(key) == "string" and key:match("^[%a_][%w_]*$") and not keywords[key] then return key end
  return "[" .. (type(key) == "string" and quoted(key) or show(key, state, limits.depth)) .. "]"
end

-- The entries of a table as texts; those beyond the limit are counted.
local function entries(t, state, depth)
  local texts, length = {}, rawlen(t)
  local keys = sorted_keys(t, length)
  for i = 1, math.min(length, limits.items) do texts[i] = show(rawget(t, i), state, depth + 1) end
  for _, key in ipairs(keys) do
    if #texts >= limits.items then break end
    texts[#texts + 1] = key_text(key, state) .. " = " .. show(rawget(t, key), state, depth + 1)
  end
  local hidden = length + #keys - #texts
  if hidden > 0 then texts[#texts + 1] = ("... %d more"):format(hidden) end
  return texts
end

-- The numbers that a list begins with stand side by side, everything else has a line of its own.
local function lines_of(texts, numbers, width)
  local lines, count = {}, 0
  for i, text in ipairs(texts) do
    local line = i <= numbers and count < limits.row and lines[#lines]
    if line and #line + #text + 3 <= width then
      lines[#lines], count = line .. ", " .. text, count + 1
    else
      lines[#lines + 1], count = text, 1
    end
  end
  return lines
end

local function leading_numbers(t)
  local count = 0
  while count < limits.items and math.type(rawget(t, count + 1)) do count = count + 1 end
  return count
end

local function table_text(t, state, depth)
  if next(t) == nil then return "{}" end
  if state[t] then return "{ (this table again) }" end
  if depth >= limits.depth then return "{ ... }" end
  state[t] = true
  local texts = entries(t, state, depth)
  state[t] = nil
  local line = "{ " .. table.concat(texts, ", ") .. " }"
  if utf8.len(line, 1, -1, true) and #line + 2 * depth <= limits.width and not line:find("\n") then return line end
  local margin = ("  "):rep(depth + 1)
  local lines = lines_of(texts, leading_numbers(t), limits.width - #margin)
  return "{\n" .. margin .. table.concat(lines, ",\n" .. margin) .. "\n" .. ("  "):rep(depth) .. "}"
end

function show(value, state, depth)
  if type(value) == "string" then return quoted(value) end
  if type(value) == "function" then return function_text(value) end
  if value ~= value then return "nan" end  -- whose sign means nothing
  if type(value) ~= "table" then return harmless(tostring(value)) end
  local meta = getmetatable(value)
  if type(meta) == "table" and rawget(meta, "__tostring") then return harmless(tostring(value)) end
  return table_text(value, state, depth)
end

-- One value. Texts are quoted.
function pretty.text(value) return show(value, {}, 0) end

-- One value in one line that is not long, without what lies deep inside.
function pretty.brief(value)
  local line = show(value, {}, limits.depth - 2):gsub("\n%s*", " ")
  return #line > limits.width and beginning(line, limits.width) .. " ..." or line
end

-- What the prompt writes for the values of an expression. A text of several lines stands as it is.
function pretty.echo(...)
  local texts = table.pack(...)
  for i = 1, texts.n do
    local value = texts[i]
    local stands = type(value) == "string" and value:find("\n", 1, true)
    texts[i] = stands and harmless(value:gsub("\n$", "")) or pretty.text(value)
  end
  return table.concat(texts, "  ", 1, texts.n)
end

return pretty

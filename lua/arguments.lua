-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Reads the command line of a script:
--
--   local options = require "meander.arguments" {
--     about = "drives a robot through the office",
--     { "--seed N", default = 7, least = 0, most = 1000, help = "seed of all random streams" },
--     { "--robot NAME", default = "scout", values = { "scout", "nomad200" }, help = "kind of robot" },
--     { "--json", help = "one JSON object per line instead of text" },
--     { "--out DIR", default = "out", help = "where pictures go" },
--     { "MAP", help = "map file" },
--     { "X Y ...", help = "goals", rest = true },
--   }
--   print(options.seed, options.json, options.MAP, options.rest[1])
--
-- An option with values takes no other words; --help lists them. A default that is a number makes the option a number, a
-- whole one if it is whole, from `least` to `most` or more than `above`. An option without a placeholder is a flag. --help
-- prints the table and ends the script; a mistake ends it with one line and exit code 2.

local did_you_mean = meander.did_you_mean

local function script_name() return (arg and arg[0] or "script"):match("[^/]*$") end

local function leave(text, code)
  io.stderr:write(script_name(), ": ", text, "\n")
  os.exit(code, true)
end

local function is_option(word) return word:sub(1, 1) == "-" and not tonumber(word) and word ~= "-" end

local function prepared(spec)
  local plan = { flags = {}, positional = {}, names = {} }
  for _, entry in ipairs(spec) do
    local name, placeholder = entry[1]:match("^(%S+)%s*(.*)$")
    if is_option(name) then
      local key = name:gsub("^%-+", ""):gsub("-", "_")
      plan.flags[name] = { key = key, entry = entry, placeholder = placeholder ~= "" and placeholder or nil }
      plan.names[#plan.names + 1] = name
    else
      plan.positional[#plan.positional + 1] = entry
    end
  end
  return plan
end

-- "a, b or c"
local function either(words)
  local last = #words
  return last == 1 and words[1] or table.concat(words, ", ", 1, last - 1) .. " or " .. words[last]
end

local function usage(spec)
  local words, lines = { "usage: " .. script_name() }, {}
  for _, entry in ipairs(spec) do
    local left = entry[1]
    local shown = entry.default ~= nil and (" [%s]"):format(tostring(entry.default)) or ""
    words[#words + 1] = is_option(left) and "[" .. left .. "]" or left
    local known = entry.values and ": " .. either(entry.values) or ""
    lines[#lines + 1] = ("  %-18s %s%s%s"):format(left, entry.help or "", known, shown)
  end
  return table.concat(words, " ") .. "\n" .. (spec.about and spec.about .. "\n" or "") .. table.concat(lines, "\n")
end

-- What is asked of a number, or nil: "1 to 1000", "at least 0", "more than 0".
local function range(entry)
  if entry.least and entry.most then return ("%s to %s"):format(entry.least, entry.most) end
  if entry.above and entry.most then return ("more than %s, at most %s"):format(entry.above, entry.most) end
  return entry.least and "at least " .. entry.least or entry.above and "more than " .. entry.above
    or entry.most and "at most " .. entry.most
end

-- The number in a text: a whole one where the default is whole, within the range of its entry.
local function number(text, entry, what)
  local default = entry.default
  local value = tonumber(text)
  local whole = math.type(default) == "integer"
  if not value or value ~= value or value == math.huge or value == -math.huge or (whole and not math.tointeger(value)) then
    leave(("%s: a %s expected, got '%s'"):format(what, whole and "whole number" or "number", text), 2)
  end
  if value < (entry.least or value) or value > (entry.most or value) or (entry.above and value <= entry.above) then
    leave(("%s: %s expected, got %s"):format(entry[1]:match "^%S+", range(entry), text), 2)
  end
  return whole and math.tointeger(value) or value
end

-- The text, if it is one of those that there are.
local function choice(text, known, what)
  for _, word in ipairs(known) do
    if word == text then return text end
  end
  leave(("%s: %s expected, got '%s'%s"):format(what, either(known), text, did_you_mean(text, known)), 2)
end

-- What the text behind an option, or in its place, stands for.
local function value_of(text, entry, what)
  if entry.values then return choice(text, entry.values, what) end
  return type(entry.default) == "number" and number(text, entry, what) or text
end

local function option(plan, values, words, i)
  local word, inline = words[i]:match("^(%-%-[^=]+)=(.*)$")
  word = word or words[i]
  local flag = plan.flags[word]
  if not flag then
    leave(("unknown option '%s'%s (known: %s)"):format(word, did_you_mean(word, plan.names), table.concat(plan.names, ", ")), 2)
  end
  if not flag.placeholder then
    if inline then leave(("option %s takes no value, got '%s'"):format(word, inline), 2) end
    values[flag.key] = true
    return i
  end
  local text = inline or words[i + 1]
  if not inline then i = i + 1 end
  if not text then leave(("option %s needs a value: %s"):format(word, flag.entry[1]), 2) end
  values[flag.key] = value_of(text, flag.entry, "option " .. word)
  return i
end

local function take_positional(plan, values, given)
  local last = plan.positional[#plan.positional]
  for i, entry in ipairs(plan.positional) do
    if entry.rest then
      values.rest = table.move(given, i, #given, 1, {})
    elseif given[i] then
      values[entry[1]] = value_of(given[i], { values = entry.values }, entry[1])
    elseif entry.default ~= nil then
      values[entry[1]] = entry.default
    else
      leave(("%s is missing: %s (--help shows how)"):format(entry[1], entry.help or ""), 2)
    end
  end
  if #given > #plan.positional and not (last and last.rest) then
    leave(("nothing more expected after %d argument(s), got '%s'"):format(#plan.positional, given[#plan.positional + 1]), 2)
  end
end

--- Reads `words` (default: the script's own) by `spec`; see the head of this file.
return function(spec, words)
  words = words or arg or {}
  local plan, values, given = prepared(spec), { rest = {} }, {}
  for _, flag in pairs(plan.flags) do values[flag.key] = flag.entry.default end
  local i = 1
  while i <= #words do
    if words[i] == "--help" or words[i] == "-h" then
      print(usage(spec))
      os.exit(0, true)
    elseif is_option(words[i]) then
      i = option(plan, values, words, i)
    else
      given[#given + 1] = words[i]
    end
    i = i + 1
  end
  take_positional(plan, values, given)
  return values
end

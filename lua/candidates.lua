-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What the examples that compare navigators share: which ones the command line names, and figures over their runs.
local report = require "meander.report"

local candidates = {}

--- The names in a list with commas, all known ones for "all". Ends the script when one is not known.
function candidates.chosen(text, known, what)
  if text == "all" then return known end
  local list = {}
  for name in text:gmatch "[^,%s]+" do
    local found = false
    for _, other in ipairs(known) do found = found or other == name end
    if not found then
      report.usage_error(("unknown %s '%s'%s (known: %s, all)"):format(
        what, name, meander.did_you_mean(name, known), table.concat(known, ", ")))
    end
    list[#list + 1] = name
  end
  if #list == 0 then report.usage_error(("--%s: at least one name expected"):format(what)) end
  return list
end

--- A function that makes a navigator by name for a robot, with the options written in `text` as in a Lua table. Ends the
--- script when one of the navigators in `names` does not take them.
function candidates.maker(text, names, robot)
  local words = setmetatable({}, { __index = function(_, word) error("unknown word '" .. tostring(word) .. "'", 0) end })
  local options = load("return {" .. text .. "}", "--options", "t", words)
  if not options then report.usage_error("--options: 'name = value, ...' expected, got '" .. text .. "'") end
  local function make(name, for_robot)
    if text == "" then return name end
    local table = options()
    table.robot = for_robot
    return meander.polar[name == "polar" and "navigator" or name](table)
  end
  for _, name in ipairs(names) do report.try(report.usage_error, "--options", make, name, robot) end
  return make
end

--- The values of one key, of all runs or those that `keep` wants.
function candidates.column(runs, key, keep)
  local values = {}
  for _, run in ipairs(runs) do
    if not keep or keep(run) then values[#values + 1] = run[key] end
  end
  return values
end

function candidates.sum(values)
  local total = 0
  for _, value in ipairs(values) do total = total + value end
  return total
end

--- Median with the ends of its interval; not a number for an empty list.
function candidates.median(values)
  if #values == 0 then return 0 / 0 end
  return meander.study.bootstrap_median(values)
end

--- The number with so many digits behind the point.
function candidates.rounded(value, digits)
  return value == value and tonumber(("%." .. digits .. "f"):format(value)) or value
end

return candidates

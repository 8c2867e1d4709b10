-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Loads a student's navigator so that all it can do is what a navigator does: look at an observation, give a command. It
-- gets copies of harmless functions and nothing that leads to the world, to files or to the tests that judge it.
-- `meander test --sandbox` adds limits of memory and computing time.

local words = { "assert", "deg", "error", "ipairs", "next", "pairs", "pcall", "print", "rad", "select", "setmetatable",
  "tonumber", "tostring", "type" }
local mathematics = { "abs", "acos", "asin", "atan", "ceil", "cos", "exp", "floor", "fmod", "huge", "log", "max", "min", "modf",
  "pi", "random", "sin", "sqrt", "tan", "tointeger", "type" }
local tables = { "concat", "insert", "move", "pack", "remove", "sort", "unpack" }

local function copy(source, names)
  local part = {}
  for _, name in ipairs(names) do part[name] = source[name] end
  return part
end

-- What a submission looks for in vain is told by name, and what there is.
local function explain(environment)
  local names = {}
  for name in pairs(environment) do names[#names + 1] = name end
  table.sort(names)
  return setmetatable(environment, { __index = function(_, name)
    if rawget(_G, name) == nil then return nil end
    error(("no '%s' here; submissions may use: %s"):format(name, table.concat(names, ", ")), 2)
  end })
end

--- The function(observation, subgoal) that the file returns, loaded anew: two calls share nothing.
return function(path)
  local environment = copy(_G, words)
  environment.math, environment.table = copy(math, mathematics), copy(table, tables)
  local chunk, problem = loadfile(path, "t", explain(environment))
  if not chunk then error(problem, 0) end
  local navigator = chunk()
  if type(navigator) ~= "function" then
    error(("%s: return function(observation, subgoal) expected, got a %s"):format(path, type(navigator)), 0)
  end
  return navigator
end

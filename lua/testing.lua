-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Scripted tests: describe, it, before_each, after_each, pending and expect. `meander test` loads a file once to see
-- which tests it has, and then once for each of them, in a state and process of its own.
local expect = require "meander.testing.expect"
require "meander.testing.matchers"
require "meander.testing.robot_matchers"
local pretty = require "meander.pretty"

local testing = {
  seed = 1,  -- of math.random and of every test, from --seed
  expect = expect.new,
  matcher = expect.matcher,
  matchers = expect.names,
}

local root = { before = {}, after = {} }
local group = root    -- where describe() stands at the moment
local tests = {}
local now             -- the test that runs

-- The line `level` calls above the caller of this one.
local function line_of(level)
  local _, text = pcall(error, "", level + 2)
  return tonumber(tostring(text):match(":(%d+): $")) or 0
end

local known_options = { points = "number", timeout = "number" }

-- Takes name, options and body apart; the options may be left out.
local function entry(what, name, options, body)
  if now then error(what .. " inside a running test; put it beside", 3) end
  if type(name) ~= "string" then error(what .. ": a name expected, got " .. pretty.text(name), 3) end
  if type(options) == "function" or options == nil and body == nil then options, body = {}, options end
  if type(options) ~= "table" then error(what .. ": a function expected, got " .. pretty.text(options), 3) end
  for key, value in pairs(options) do
    local kind = known_options[key]
    if not kind then error(("%s: unknown option '%s' (known: points, timeout)"):format(what, tostring(key)), 3) end
    if type(value) ~= kind or not (value > 0 and value < math.huge) then
      error(("%s: option '%s': a number > 0 expected, got %s"):format(what, key, pretty.text(value)), 3)
    end
  end
  return options, body
end

local function callable(what, body)
  if type(body) ~= "function" then error(what .. ": a function expected, got " .. pretty.text(body), 3) end
end

-- The names of the groups around, outermost first, and then `name`.
local function path_to(name)
  local path = { name }
  local at = group
  while at ~= root do
    table.insert(path, 1, at.name)
    at = at.parent
  end
  return path
end

local function add(name, options, body, skip, line)
  tests[#tests + 1] = {
    path = path_to(name), line = line, group = group, body = body, skip = skip,
    points = options.points, timeout = options.timeout or group.timeout,
  }
end

--- Puts the tests that `body` defines under one name; groups nest. options.timeout [s] holds for all of them.
function testing.describe(name, options, body)
  options, body = entry("describe", name, options, body)
  callable("describe", body)
  if options.points then error("describe: points belong to single tests", 2) end
  group = { name = name, parent = group, before = {}, after = {}, timeout = options.timeout or group.timeout }
  body()
  group = group.parent
end

--- One test. Its body gets the seed. Without a body it is left for later, and counts as skipped.
function testing.it(name, options, body)
  options, body = entry("it", name, options, body)
  if body ~= nil then callable("it", body) end
  add(name, options, body, body == nil and "not written yet" or nil, line_of(2))
end

--- Beside tests: a test that is left out, with its name. Inside a test: ends it as skipped, with the reason.
function testing.pending(text, ...)
  if now then
    now.skip = tostring(text or "pending")
    error("pending: " .. now.skip, 2)
  end
  local options = entry("pending", text, ...)
  add(text, options, nil, "pending", line_of(2))
end

--- Runs before every test of the group and of the groups inside, outer ones first.
function testing.before_each(body)
  if now then error("before_each inside a running test; put it beside", 2) end
  callable("before_each", body)
  table.insert(group.before, body)
end

--- Runs after every test of the group and of the groups inside, inner ones first, also when the test failed.
function testing.after_each(body)
  if now then error("after_each inside a running test; put it beside", 2) end
  callable("after_each", body)
  table.insert(group.after, body)
end

-- A test that ends the program has not shown what it should: it fails at that line, even from inside a pcall.
local function refuse_exit()
  if not rawget(_G, "os") then return end
  os.exit = function(code)
    if not now then error("os.exit called outside of a test", 2) end
    local _, text = pcall(error, ("os.exit(%s) called in a test"):format(code == nil and "" or pretty.text(code)), 3)
    now.exited = now.exited or text
    error(text, 0)
  end
end

--- For the runner: makes the words of a test file global and takes over what the command line says.
function testing.install(seed)
  testing.seed = seed
  math.randomseed(seed)
  rawset(meander, "testing", testing)
  for _, name in ipairs { "describe", "it", "before_each", "after_each", "pending", "expect" } do
    rawset(_G, name, testing[name])
  end
  refuse_exit()
end

--- For the runner: what the file has defined.
function testing.list()
  local list = {}
  for i, test in ipairs(tests) do
    list[i] = { path = test.path, line = test.line, skip = test.skip, points = test.points, timeout = test.timeout }
  end
  return list
end

-- The hooks `which` of all groups around a test, outermost group first.
local function hooks(at, which)
  local groups = {}
  while at do
    table.insert(groups, 1, at[which])
    at = at.parent
  end
  return groups
end

--- For the runner: the test with its preparation, by its place in the list.
function testing.body(index)
  local test = tests[index]
  return function()
    math.randomseed(testing.seed)
    now = test
    for _, bodies in ipairs(hooks(test.group, "before")) do
      for _, body in ipairs(bodies) do body(testing.seed) end
    end
    test.body(testing.seed)
  end
end

--- For the runner: what comes after it. All of it runs; the first error is told.
function testing.cleanup(index)
  local groups = hooks(tests[index].group, "after")
  return function()
    local failed, problem = false, nil
    for i = #groups, 1, -1 do
      for _, body in ipairs(groups[i]) do
        local ok, why = pcall(body, testing.seed)
        if not ok and not failed then failed, problem = true, why end
      end
    end
    if failed then error(problem, 0) end
  end
end

--- For the runner: what is to be said about the test that ran, besides its own error.
function testing.verdict()
  local idle = expect.left_idle()
  return { skip = now.skip, exited = now.exited, idle = idle and idle .. "expect(...) without a matcher" or nil }
end

return testing

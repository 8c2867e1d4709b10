-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- expect(value):matcher(...): each matcher checks at once, raises a failure at its caller's line and returns the
-- expectation, so that matchers chain. `never` turns the next one round.
local did_you_mean = meander.did_you_mean
local pretty = require "meander.pretty"

local expect = {}

local matchers = {}  -- name -> function(expectation, ...): did it hold, and what happened instead
local idle = {}      -- expectation without a matcher so far -> where it was written
local Expectation = {}

--- The names of all matchers, sorted.
function expect.names()
  local names = { "never" }
  for name in next, matchers do names[#names + 1] = name end
  table.sort(names)
  return names
end

-- "demo_test.lua:12: " of the function `level` calls above the caller of this one.
local function position(level)
  local _, text = pcall(error, "", level + 2)
  return text
end

local own = position(1):match("^(.*testing)")  -- how positions within these modules begin
local deepest = 40

--- Raises `text` at the nearest line that is not of these modules.
function expect.raise(text)
  for level = 1, deepest do
    local where = position(level)
    if where ~= "" and where:sub(1, #own) ~= own then error(where .. text, 0) end
  end
  error(text, 0)
end
local raise = expect.raise

local function arguments_text(...)
  local texts = table.pack(...)
  for i = 1, texts.n do texts[i] = pretty.text(texts[i]) end
  return table.concat(texts, ", ")
end

-- The method `name`: checks who calls, lets the matcher judge, raises what it says.
local function method(name, judge)
  return function(self, ...)
    if getmetatable(self) ~= Expectation then
      raise(("%s: call it with ':', as in expect(value):%s(...)"):format(name, name))
    end
    idle[self] = nil
    local never = rawget(self, "negated")
    rawset(self, "negated", false)
    local ok, text = judge(self, ...)
    if never then
      text = ("expected never %s(%s), got %s"):format(name, arguments_text(...), pretty.text(rawget(self, "value")))
    end
    if (not ok) ~= never then raise(text or ("%s does not hold for %s"):format(name, pretty.text(rawget(self, "value")))) end
    return self
  end
end

function Expectation.__index(self, name)
  if name == "never" then
    rawset(self, "negated", not rawget(self, "negated"))
    return self
  end
  if matchers[name] then return matchers[name] end
  raise(("no matcher '%s'%s"):format(tostring(name), did_you_mean(tostring(name), expect.names())))
end

-- expect(x):never():equals(1) and expect(x).never:equals(1) mean the same.
function Expectation.__call(self) return self end

function Expectation.__newindex(_, name) raise(("an expectation takes no field '%s'"):format(tostring(name))) end

function Expectation.__tostring(self) return "expectation about " .. pretty.text(rawget(self, "value")) end

Expectation.__metatable = Expectation

--- Begins an expectation about a value.
function expect.new(...)
  if select("#", ...) > 1 then raise(("expect takes one value, got %d"):format(select("#", ...))) end
  local expectation = setmetatable({ value = (...), negated = false }, Expectation)
  idle[expectation] = position(2)
  return expectation
end

--- Adds a matcher that sees the whole expectation; matchers behind it in the chain read what it leaves there by rawset.
function expect.define(name, judge) matchers[name] = method(name, judge) end

--- Adds a matcher of a user: judge(value, ...) returns whether it holds, and what to say when it does not.
function expect.matcher(name, judge)
  if type(name) ~= "string" or not name:match("^[%a_][%w_]*$") then
    raise("meander.testing.matcher: a name expected, got " .. pretty.text(name))
  end
  if type(judge) ~= "function" then
    raise("meander.testing.matcher: a function(value, ...) expected, got " .. pretty.text(judge))
  end
  if name == "never" or matchers[name] then raise(("meander.testing.matcher: '%s' exists already"):format(name)) end
  expect.define(name, function(self, ...) return judge(rawget(self, "value"), ...) end)
end

--- Where an expect(...) stands that no matcher followed, or nil.
function expect.left_idle()
  local _, where = next(idle)
  return where
end

return expect

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Matchers about runs, simulations and worlds. They judge by the truth, not by what the robot believes, and say what
-- happened instead.
local difference = require "meander.testing.difference"
local expect = require "meander.testing.expect"
local kind_of = meander.kind
local pretty = require "meander.pretty"

local define = expect.define

-- Beside points that bring no tolerance of their own [m].
local point_tolerance = 0.3
-- A hull this near to an obstacle touches it [m].
local touching = 1e-3

local wrong_use = expect.raise

-- The value of an expectation, which must be of one of these kinds.
local function subject(self, name, kinds)
  local value = rawget(self, "value")
  local kind = kind_of(value)
  for _, wanted in ipairs(kinds) do
    if kind == wanted then return value, kind end
  end
  wrong_use(("%s: expect(%s) needed, got %s"):format(name, table.concat(kinds, " or "), pretty.text(value)))
end

local function number(value, name, what)
  if type(value) ~= "number" or value ~= value then
    wrong_use(("%s: %s expected, got %s"):format(name, what, pretty.text(value)))
  end
  return value
end

local function point_text(x, y) return ("(%.2f, %.2f)"):format(x, y) end

-- Times and positions of all recorded cycles.
local function trace(run)
  if run.steps == 0 then wrong_use("the run has no recorded cycles: drive it with record_every = 1") end
  return run:trace "time", run:trace "x", run:trace "y"
end

local function moment(run, i)
  local time, x, y = trace(run)
  return ("at %s after %.1f s"):format(point_text(x[i], y[i]), time[i])
end

local function times(count) return count == 1 and "once" or count == 2 and "twice" or count .. " times" end

local function ending(run)
  local subgoals = run.subgoals > 0 and ("%d of %d subgoals"):format(run.reached, run.subgoals)
    or ("%d subgoal%s"):format(run.reached, run.reached == 1 and "" or "s")
  local where = run.steps > 0 and moment(run, run.steps) or ("after %.1f s"):format(run.time)
  local touched = run.contacts > 0 and (", touched something %s"):format(times(run.contacts)) or ""
  return ("reached %s%s; ended %s: %s"):format(subgoals, touched, where, run.reason)
end

-- Position, tolerance and name of what a test calls a place: a name, a thing or a point.
local function place_of(run, place)
  if type(place) == "table" then
    local x, y = place.x or place[1], place.y or place[2]
    if type(x) ~= "number" or type(y) ~= "number" then wrong_use("reaches: {x, y} expected, got " .. pretty.text(place)) end
    return x, y, place.tolerance or point_tolerance, point_text(x, y)
  end
  for _, goal in ipairs(run.goals) do
    if type(place) == "string" and goal.name == place then return goal.x, goal.y, goal.tolerance, ("'%s'"):format(place) end
  end
  local ok, entry = pcall(function() return run.world:get(place) end)
  if not ok then wrong_use("reaches: " .. tostring(entry):gsub("^.-world:get: ", "")) end
  if entry.kind ~= "place" then wrong_use(("reaches: a place expected, '%s' is of kind %s"):format(entry.name, entry.kind)) end
  return entry.position.x, entry.position.y, entry.tolerance, ("'%s'"):format(entry.name)
end

-- When the robot first came this near; otherwise nil, how near it came, and in which cycle.
local function approach(run, px, py, tolerance)
  local time, x, y = trace(run)
  local nearest, cycle = math.huge, 1
  for i = 1, #time do
    local off = math.sqrt((x[i] - px) ^ 2 + (y[i] - py) ^ 2)
    if off <= tolerance then return time[i] end
    if off < nearest then nearest, cycle = off, i end
  end
  return nil, nearest, cycle
end

local function reaches_place(self, run, place, tolerance)
  local x, y, own, name = place_of(run, place)
  local at, nearest, cycle = approach(run, x, y, tolerance or own)
  if at then
    rawset(self, "reached_at", at)
    rawset(self, "reached_what", name)
    return true
  end
  return false, ("did not reach %s: at best %.2f m from it, %s, where %g m would do; %s"):format(name, nearest, moment(run, cycle),
    tolerance or own, ending(run))
end

local function reaches_count(self, run, count)
  rawset(self, "reached_at", run.time)
  rawset(self, "reached_what", count == 1 and "1 subgoal" or count .. " subgoals")
  return run.reached >= count, ("expected %d subgoal%s: %s"):format(count, count == 1 and "" or "s", ending(run))
end

--- reaches(): all subgoals; reaches(2): so many of them; reaches(place, tolerance): the true path comes that near.
define("reaches", function(self, place, tolerance)
  local run = subject(self, "reaches", { "run" })
  if tolerance ~= nil then number(tolerance, "reaches", "a tolerance [m]") end
  if place == nil then
    rawset(self, "reached_at", run.time)
    rawset(self, "reached_what", "the end")
    return run.success and run.reached >= run.subgoals, ending(run)
  end
  if type(place) == "number" then return reaches_count(self, run, place) end
  return reaches_place(self, run, place, tolerance)
end)

define("within", function(self, seconds)
  local run = subject(self, "within", { "run" })
  number(seconds, "within", "a time [s]")
  local at = rawget(self, "reached_at") or run.time
  local what = rawget(self, "reached_what")
  return at <= seconds, ("%s after %.1f s, %g s allowed"):format(what and "reached " .. what or "ended", at, seconds)
end)

-- The first recorded cycle in contact, or the nearest to it.
local function first_touch(run)
  if run.steps == 0 then return "" end
  local clearance = run:trace "clearance"
  for i = 1, #clearance do
    if clearance[i] < touching then return ", first " .. moment(run, i) end
  end
  local _, least = clearance:min()
  return ", nearest " .. moment(run, least)
end

local function contacts(value, kind, key)
  if kind == "run" then return value[key] end
  local sum = 0
  for _, robot in ipairs(value.robots) do sum = sum + robot[key] end
  return sum
end

local function touch_matcher(name, key, whose)
  define(name, function(self)
    local value, kind = subject(self, name, { "run", "sim" })
    local count = contacts(value, kind, key)
    local all = contacts(value, kind, "contacts")
    local more = all > count and (" (%d contacts in all)"):format(all) or ""
    return count == 0, ("touched something %s%s%s%s"):format(times(count), whose, more, kind == "run" and first_touch(value) or "")
  end)
end
touch_matcher("touches_nothing", "contacts", "")
touch_matcher("touches_nothing_by_its_fault", "fault_contacts", " by its own motion")

define("keeps", function(self, clearance)
  local run = subject(self, "keeps", { "run" })
  number(clearance, "keeps", "a clearance [m]")
  local where = ""
  if run.steps > 0 then
    local _, least = run:trace("clearance"):min()
    where = " " .. moment(run, least)
  end
  return run.clearance_min >= clearance, ("came within %.3f m of an obstacle%s, %g m expected"):format(run.clearance_min, where, clearance)
end)

define("shorter_than", function(self, length)
  local run = subject(self, "shorter_than", { "run" })
  number(length, "shorter_than", "a length [m]")
  return run.length < length, ("drove %.2f m, less than %g m expected; %s"):format(run.length, length, ending(run))
end)

define("ends_because", function(self, words)
  local run = subject(self, "ends_because", { "run" })
  if type(words) ~= "string" then wrong_use("ends_because: a text expected, got " .. pretty.text(words)) end
  return run.reason:find(words, 1, true) ~= nil, ("expected an end because of %s; %s"):format(pretty.text(words), ending(run))
end)

define("is_at", function(self, point, tolerance)
  local value, kind = subject(self, "is_at", { "run", "sim" })
  local x, y
  if kind == "sim" then
    x, y = value.pose.x, value.pose.y
  else
    local _, xs, ys = trace(value)
    x, y = xs[#xs], ys[#ys]
  end
  if type(point) ~= "table" then wrong_use("is_at: {x, y} expected, got " .. pretty.text(point)) end
  local px, py = number(point.x or point[1], "is_at", "x"), number(point.y or point[2], "is_at", "y")
  local off, allowed = math.sqrt((x - px) ^ 2 + (y - py) ^ 2), tolerance or point_tolerance
  return off <= allowed, ("is at %s, %.2f m from %s; %g m would do"):format(point_text(x, y), off, point_text(px, py), allowed)
end)

-- Where two runs part, in words.
local function parting(a, b)
  if a.steps == 0 or b.steps == 0 then return "" end
  local time, ax, ay = trace(a)
  local _, bx, by = trace(b)
  for i = 1, math.min(#ax, #bx) do
    if ax[i] ~= bx[i] or ay[i] ~= by[i] then
      return (": they part after %.1f s, at (%.9g, %.9g) and (%.9g, %.9g)"):format(time[i], ax[i], ay[i], bx[i], by[i])
    end
  end
  if #ax == #bx then return "" end
  return (": alike for %d cycles, then one goes on to %d"):format(math.min(#ax, #bx), math.max(#ax, #bx))
end

local function hash_of(value, kind)
  if kind == "run" then return value.hash end
  return value:hash()
end

--- Of a function: calling it twice gives the same. Of a run, sim or world: it has the hash of the other one.
define("repeats", function(self, other)
  local value, kind = subject(self, "repeats", { "function", "run", "sim", "world" })
  if kind == "function" then value, other = value(), value() end
  kind = kind_of(value)
  if kind ~= kind_of(other) then wrong_use(("repeats: a %s expected, got %s"):format(kind, pretty.text(other))) end
  if kind == "run" or kind == "sim" or kind == "world" then
    local a, b = hash_of(value, kind), hash_of(other, kind)
    return a == b, ("hashes %s and %s%s"):format(a, b, kind == "run" and parting(value, other) or "")
  end
  local lines = difference.lines(value, other)
  return #lines == 0, table.concat(lines, "\n")
end)

--- has(name): there is a thing of that name or pattern; has(name, count): so many of them.
define("has", function(self, name, count)
  local world = subject(self, "has", { "world" })
  if type(name) ~= "string" then wrong_use("has: a name or pattern expected, got " .. pretty.text(name)) end
  local found = #world:names(name)
  if count ~= nil then return found == count, ("expected %s of '%s', got %d in %s"):format(pretty.text(count), name, found, tostring(world)) end
  return found > 0, ("nothing is called '%s' in %s"):format(name, tostring(world))
end)

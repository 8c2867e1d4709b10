-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Drives through any map that meander can import: meander worlds, ROS maps, floor plans, BARN worlds.
--
--   ./meander examples/drive_map.lua depot.yaml  START_X START_Y  X Y [X Y ...]
--   ./meander examples/drive_map.lua worlds/office.toml  X Y
--
-- Metres in the frame of the map. Of two or more points the first is the start; a single point is the goal, from the start
-- that the map itself names. With --seeds N each navigator drives that way N times, from another heading and with other noise
-- each time, and figures over all runs are printed:
--
--   ./meander examples/drive_map.lua worlds/office.toml 6.0 4.5 --seeds 20 --navigator all
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "drives through any importable map; of two or more points the first is the start",
  { "--seed N", default = 7, least = 0, most = 1000000000, help = "seed of all random streams; the first of several" },
  { "--seeds N", default = 1, least = 1, most = 1000000, help = "runs of each navigator" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the picture and the record" },
  { "--heading DEG", default = 0.0, help = "heading at the start, in degrees" },
  { "--resolution M", default = 0.05, above = 0, help = "metres per pixel of a plain image" },
  { "--unknown HOW", default = "auto", values = { "auto", "free", "occupied" }, help = "unknown cells of a ROS map" },
  { "--index N", default = 0, least = 0, help = "which world of a BARN file" },
  { "--navigator NAMES", default = "polar", help = "who drives; with --seeds also several with commas, or all" },
  { "--robot NAME", default = "nomad200", values = meander.robot.platforms(), help = "kind of robot" },
  { "--radius M", default = 0.0, least = 0, most = 10, help = "of its body, with the rings on it; 0: its own" },
  { "--sonar NAME", default = "nomad", values = meander.sensor.sonars(), help = "sonar preset" },
  { "--tolerance M", default = 0.25, above = 0, most = 1000000, help = "a point is reached from so far" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--time-limit S", default = 600.0, above = 0, most = 1000000000, help = "simulated seconds until the drive is given up" },
  { "MAP", help = "map file" },
  { "X Y ...", help = "points in metres", rest = true },
}

-- {x, y} pairs from the words behind the map.
local function points(words)
  if #words < 2 or #words % 2 == 1 then
    report.usage_error("pairs X Y of metres expected behind the map, got " .. #words .. " number(s)")
  end
  local list = {}
  for i = 1, #words, 2 do
    local x, y = tonumber(words[i]), tonumber(words[i + 1])
    if not x or not y then
      report.usage_error(("pairs X Y of metres expected, got '%s %s'"):format(words[i], words[i + 1]))
    end
    list[#list + 1] = { x, y }
  end
  return list
end

local goals = points(options.rest)
local navigators = candidates.chosen(options.navigator, meander.autonomy.navigators(), "navigator")
if options.seeds == 1 and #navigators > 1 then report.usage_error "--navigator: several are compared with --seeds N only" end
local world, notes = report.try(report.failure, nil, meander.world.import, options.MAP, {
  resolution = options.resolution, unknown = options.unknown, index = options.index,
})
for _, line in ipairs(notes) do io.stderr:write(line, "\n") end

local start
if #goals > 1 then
  local first = table.remove(goals, 1)
  start = { first[1], first[2], deg(options.heading) }
elseif not world.start then
  report.usage_error("two points needed, start and goal: the map names no start")
end
for i, goal in ipairs(goals) do goals[i] = { x = goal[1], y = goal[2], tolerance = options.tolerance } end

local robot = { preset = options.robot }
if options.radius > 0 then
  robot.body, robot.bumper = { radius = options.radius }, { radius = options.radius }
  robot.sonar = { radius = 0.86 * options.radius }
end

local function drive(navigator, seed, from, more)
  local sim = meander.sim.new { world = world, robot = robot, sonar = options.sonar, start = from, seed = seed }
  local how = { navigator = navigator, subgoals = goals, time_limit = options.time_limit }
  for key, value in pairs(more) do how[key] = value end
  return sim:drive(how)
end

-- Where something of this cannot be, a drive of no time says so.
report.try(report.usage_error, nil, drive, navigators[1], options.seed, start, { time_limit = 0, record_every = 0 })

if options.seeds == 1 then
  report.run("drive_map", drive(navigators[1], options.seed, start, {}), options)
  os.exit(0, true)
end

-- Headings that are spread over the circle, however many.
local function turned(seed)
  local from = start or { world.start.x, world.start.y, world.start.heading }
  return { from[1], from[2], deg(options.heading + seed * 137.508 % 360) }
end

local keys = {
  "navigator", "n", "reached", "points_reached", "points", "contacts", "fault_contacts", "trapped", "time_median",
  "length_median", "clearance_min",
}
local column, sum = candidates.column, candidates.sum

local function say(name, runs)
  local arrived = function(run) return run.success end
  local reached, least = #column(runs, "time", arrived), math.huge
  for _, run in ipairs(runs) do least = math.min(least, run.clearance) end
  local points_reached = math.tointeger(sum(column(runs, "reached")))
  local contacts, faults = math.tointeger(sum(column(runs, "contacts"))), math.tointeger(sum(column(runs, "fault_contacts")))
  local trapped = #column(runs, "time", function(run) return run.trapped > 0 end)
  local time, time_low, time_high = candidates.median(column(runs, "time", arrived))
  local length = candidates.median(column(runs, "length", arrived))
  if options.json then
    print(json.encode({
      navigator = name, n = #runs, reached = reached, points_reached = points_reached, points = #goals * #runs,
      contacts = contacts, fault_contacts = faults, trapped = trapped, time_median = candidates.rounded(time, 3),
      length_median = candidates.rounded(length, 3), clearance_min = candidates.rounded(least, 3),
    }, keys))
    return
  end
  local share, low, high = meander.study.wilson(reached, #runs)
  print(("%s: the whole way in %d of %d runs: %.0f %% (%.0f to %.0f %%); %d of %d points"):format(
    name, reached, #runs, 100 * share, 100 * low, 100 * high, points_reached, #goals * #runs))
  print(("  contacts %d, of these %d the robot's own fault; least clearance %.3f m; trapped in %d runs"):format(
    contacts, faults, least, trapped))
  if reached > 0 then print(("  time %.1f s (%.1f to %.1f), way %.2f m"):format(time, time_low, time_high, length)) end
end

for _, name in ipairs(navigators) do
  local runs, seeds = {}, {}
  for i = 1, options.seeds do seeds[i] = options.seed + i - 1 end
  for i, result in ipairs(meander.study.trials { seeds = seeds, jobs = options.jobs, trial = function(seed)
    local run = drive(name, seed, turned(seed), { when_trapped = "insist", record_every = 0 })
    return {
      success = run.success, reached = run.reached, contacts = run.contacts, fault_contacts = run.fault_contacts,
      trapped = run.trapped, time = run.time, length = run.length, clearance = run.clearance_min,
    }
  end }) do
    if not result.ok then error(("%s, seed %d: %s"):format(name, result.seed, result.error), 0) end
    runs[i] = result.value
  end
  say(name, runs)
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The BARN benchmark (Perille, Truong, Xiao and Stone 2020): 10 m through a field of thin poles in 100 s without touching
-- one. Scored by the benchmark's own metric, success x OT / clip(AT, 2 OT, 8 OT), where AT is the time taken and OT that of
-- the reference path at 2 m/s: at most 0.5. The robot is a disc with sonars, not the benchmark's, so that the scores
-- compare navigators with each other and with nothing else.
--
--   ./meander examples/barn.lua static_cylinders.csv reference_paths.csv --worlds 0-99 --navigator polar
local candidates = require "meander.candidates"
local fields = require "meander.pole_fields"
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "drives navigators through the worlds of the BARN benchmark",
  { "--worlds A-B", default = "0-149", help = "numbers of the worlds" },
  { "--navigator NAMES", default = "polar", help = "one or several with commas, or all" },
  { "--options TEXT", default = "", help = "options of the navigator instead of those for this robot, as in a Lua table" },
  {
    "--sonars N", default = 16, least = 1, most = 1024,
    help = "sonars of the ring, each with a cone as wide as its share of the circle at most",
  },
  { "--speed V", default = 2.0, above = 0, most = 10, help = "largest speed of the robot, m/s" },
  { "--sonar NAME", default = "nomad", values = { "ideal", "nomad", "real" }, help = "model of the sonars" },
  { "--first-seed S", default = 2000, least = 0, most = 1000000000, help = "world k is driven with seed S + k" },
  { "--json", help = "one JSON object per navigator instead of text" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--out DIR", default = "", help = "folder for pictures of runs that did not succeed; none when empty" },
  { "--generated", help = "fields drawn from the seeds A-B instead of the benchmark's; no files then" },
  { "CYLINDERS", default = "", help = "table world,x_m,y_m,radius_m" },
  { "PATHS", default = "", help = "table world,seq,col0,col1 of the reference paths" },
}

if not options.generated and options.PATHS == "" then
  report.usage_error "CYLINDERS and PATHS expected: the benchmark's tables (--help shows how)"
end
local navigators = candidates.chosen(options.navigator, meander.autonomy.navigators(), "navigator")
local robot = fields.robot(options.sonars, options.speed)
local navigator_of = options.options == "" and fields.navigator or candidates.maker(options.options, navigators, robot)
local sonar = fields.sonar(options.sonar, options.sonars)

-- Cell (col0, col1) of a path is at x = 0.15 col0 - 4.575, y = 0.15 col1 + 5.075 [m]. A path begins and ends inside the
-- field; the way from the start and to the goal comes on top.
local function path_lengths(file)
  local points, lengths = {}, {}
  local lines = report.try(report.usage_error, "PATHS", io.lines, file)
  local head = lines()
  if head ~= "world,seq,col0,col1" then report.usage_error(file .. ":1: world,seq,col0,col1 expected, got '" .. tostring(head) .. "'") end
  local number = 1
  for line in lines do
    number = number + 1
    local world, _, col0, col1 = line:match "^(%d+),(%d+),(%-?%d+),(%-?%d+)%s*$"
    if not world then report.usage_error(("%s:%d: four whole numbers expected, got '%s'"):format(file, number, line)) end
    world = math.tointeger(tonumber(world))
    points[world] = points[world] or {}
    table.insert(points[world], { 0.15 * col0 - 4.575, 0.15 * col1 + 5.075 })
  end
  for world, list in pairs(points) do lengths[world] = fields.path_length(list) end
  return lengths
end

local function drive(name, number, length)
  local world
  if options.generated then
    world, length = fields.make(number)
  else
    world = meander.world.import(options.CYLINDERS, { index = number })
  end
  local result, run = fields.drive {
    world = world, length = length, navigator = navigator_of(name, robot), robot = robot, sonar = sonar,
    seed = options.first_seed + number, record_every = options.out == "" and 0 or 1,
  }
  if options.out ~= "" and not result.success then
    result.picture = report.path(options, ("barn_%s_%d.svg"):format(name, number))
    run:save(result.picture)
  end
  return result
end

local kMost = 100000
local first, last = options.worlds:match "^(%d+)%-(%d+)$"
if not first then first, last = options.worlds:match "^%d+$", options.worlds end
first, last = math.tointeger(tonumber(first)), math.tointeger(tonumber(last))
if not first or not last or first > last or last > kMost then
  report.usage_error(("--worlds: A-B expected, numbers up to %d, got '%s'"):format(kMost, options.worlds))
end
local lengths = options.generated and {} or path_lengths(options.PATHS)
if not options.generated then
  report.try(report.usage_error, "CYLINDERS", meander.world.import, options.CYLINDERS, { index = first })
end
for world = first, options.generated and first - 1 or last do
  if not lengths[world] then report.usage_error(("%s: no path of world %d"):format(options.PATHS, world)) end
end

local keys = {
  "navigator", "worlds", "success", "collided", "timeout", "metric_mean", "against", "metric_difference",
  "metric_difference_low", "metric_difference_high", "pictures",
}

-- `first`: name and runs of the first navigator, with which the others are compared world by world; nil for itself.
local function say(name, runs, first)
  local column, count = candidates.column, #runs
  local success = #column(runs, "time", function(run) return run.success end)
  local collided = #column(runs, "time", function(run) return run.collided end)
  local late = count - success - collided
  local metric, low, high = meander.study.bootstrap_mean(column(runs, "metric"))
  local more, more_low, more_high
  if first then more, more_low, more_high = meander.study.compare(column(runs, "metric"), column(first.runs, "metric")) end
  local pictures = column(runs, "picture")
  if options.json then
    print(json.encode({
      navigator = name, worlds = count, success = success, collided = collided, timeout = late,
      metric_mean = candidates.rounded(metric, 4), against = first and first.name,
      metric_difference = more and candidates.rounded(more, 4), metric_difference_low = more and candidates.rounded(more_low, 4),
      metric_difference_high = more and candidates.rounded(more_high, 4), pictures = pictures[1] and pictures,
    }, keys))
    return
  end
  local share, share_low, share_high = meander.study.wilson(success, count)
  print(("%s, %d worlds: success %d, %.0f %% (%.0f to %.0f %%), collided %d, out of time %d"):format(
    name, count, success, 100 * share, 100 * share_low, 100 * share_high, collided, late))
  print(("  metric %.3f (%.3f to %.3f), time %.1f s, median of the successes"):format(
    metric, low, high, (candidates.median(column(runs, "time", function(run) return run.success end)))))
  if first then
    print(("  metric less that of %s in the same worlds: %+.3f (%+.3f to %+.3f)"):format(first.name, more, more_low, more_high))
  end
  if #pictures > 0 then print("  pictures  " .. table.concat(pictures, " ")) end
end

local numbers = {}
for world = first, last do numbers[#numbers + 1] = world end
local compared
for _, name in ipairs(navigators) do
  local runs = {}
  for i, result in ipairs(meander.study.trials { seeds = numbers, jobs = options.jobs, trial = function(world)
    return drive(name, world, lengths[world])
  end }) do
    if not result.ok then error(("%s, world %d: %s"):format(name, result.seed, result.error), 0) end
    runs[i] = result.value
  end
  say(name, runs, compared)
  compared = compared or { name = name, runs = runs }
end

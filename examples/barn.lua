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
  { "--sonars N", default = 16, help = "sonars of the ring, each with a cone as wide as its share of the circle at most" },
  { "--speed V", default = 2.0, help = "largest speed of the robot, m/s" },
  { "--sonar NAME", default = "nomad", help = "ideal, nomad or real" },
  { "--first-seed S", default = 2000, help = "world k is driven with seed S + k" },
  { "--json", help = "one JSON object per navigator instead of text" },
  { "--jobs N", default = 0, help = "worker processes; 0: one per core" },
  { "--out DIR", default = "", help = "folder for pictures of runs that did not succeed; none when empty" },
  { "--generated", help = "fields drawn from the seeds A-B instead of the benchmark's; no files then" },
  { "CYLINDERS", default = "", help = "table world,x_m,y_m,radius_m" },
  { "PATHS", default = "", help = "table world,seq,col0,col1 of the reference paths" },
}

if not options.generated and options.PATHS == "" then
  report.usage_error "CYLINDERS and PATHS expected: the benchmark's tables (--help shows how)"
end
candidates.chosen(options.sonar, { "ideal", "nomad", "real" }, "sonar")
if options.sonars < 1 then report.usage_error("--sonars: at least 1 expected, got " .. options.sonars) end
if options.speed <= 0 then report.usage_error("--speed: more than 0 m/s expected, got " .. options.speed) end
local navigator_of = options.options == "" and fields.navigator or candidates.maker(options.options)
local robot = fields.robot(options.sonars, options.speed)
local sonar = fields.sonar(options.sonar, options.sonars)

-- Cell (col0, col1) of a path is at x = 0.15 col0 - 4.575, y = 0.15 col1 + 5.075 [m]. A path begins and ends inside the
-- field; the way from the start and to the goal comes on top.
local function path_lengths(file)
  local points, lengths = {}, {}
  local lines = io.lines(file)
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
    run:save(report.path(options, ("barn_%s_%d.svg"):format(name, number)))
  end
  return result
end

local first, last = options.worlds:match "^(%d+)%-(%d+)$"
if not first then first, last = options.worlds:match "^%d+$", options.worlds end
first, last = math.tointeger(tonumber(first)), math.tointeger(tonumber(last))
if not first or first > last then report.usage_error("--worlds: A-B expected, got '" .. options.worlds .. "'") end
local lengths = options.generated and {} or path_lengths(options.PATHS)
for world = first, options.generated and first - 1 or last do
  if not lengths[world] then report.usage_error(("%s: no path of world %d"):format(options.PATHS, world)) end
end

local keys = { "navigator", "worlds", "success", "collided", "timeout", "metric_mean" }

local function say(name, runs)
  local column, count = candidates.column, #runs
  local success = #column(runs, "time", function(run) return run.success end)
  local collided = #column(runs, "time", function(run) return run.collided end)
  local late = count - success - collided
  local metric, low, high = meander.study.bootstrap_mean(column(runs, "metric"))
  if options.json then
    print(json.encode({
      navigator = name, worlds = count, success = success, collided = collided, timeout = late,
      metric_mean = candidates.rounded(metric, 4),
    }, keys))
    return
  end
  local share, share_low, share_high = meander.study.wilson(success, count)
  print(("%s, %d worlds: success %d, %.0f %% (%.0f to %.0f %%), collided %d, out of time %d"):format(
    name, count, success, 100 * share, 100 * share_low, 100 * share_high, collided, late))
  print(("  metric %.3f (%.3f to %.3f), time %.1f s, median of the successes"):format(
    metric, low, high, (candidates.median(column(runs, "time", function(run) return run.success end)))))
end

local numbers = {}
for world = first, last do numbers[#numbers + 1] = world end
for _, name in ipairs(candidates.chosen(options.navigator, meander.autonomy.navigators(), "navigator")) do
  local runs = {}
  for i, result in ipairs(meander.study.trials { seeds = numbers, jobs = options.jobs, trial = function(world)
    return drive(name, world, lengths[world])
  end }) do
    if not result.ok then error(("%s, world %d: %s"):format(name, result.seed, result.error), 0) end
    runs[i] = result.value
  end
  say(name, runs)
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- How real is the sonar model? Holds a recorded log (CSV, one frame per row, ranges in metres, robot following the wall on
-- its left) against the same drive in simulation, fits the model's parameters to it if asked, and tells how the fitted
-- statistics carry over to other rooms. Without a log it records one itself, so that the way can be tried.
--
--   ./meander examples/sonar_fit.lua LOG                               the `real` preset against the log
--   ./meander examples/sonar_fit.lua LOG --rooms 100 --generations 40  look for a room, then fit
local json = require "meander.json"
local report = require "meander.report"
local log = require "sonar_fit.log"
local room = require "sonar_fit.room"
local search = require "sonar_fit.search"
local statistics = require "sonar_fit.statistics"

local options = require "meander.arguments" {
  about = "holds the sonar model against a recorded log, and fits it",
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object per line instead of text" },
  { "--out DIR", default = "out", help = "folder of the table" },
  { "--rate HZ", default = 9.0, help = "frames per second of the log" },
  { "--frames N", default = 0, help = "frames to simulate; 0: as many as the log has" },
  { "--room N", default = 447, help = "number of the simulated room; 447 is nearest to the SCITOS log" },
  { "--rooms N", default = 0, help = "look through so many rooms for the best one" },
  { "--generations N", default = 0, help = "generations of the fit; 0: no fit" },
  { "--fit WHAT", default = "all", values = { "all", "drive" }, help = "sonar and drive, or only ring radius, distance and speed" },
  { "--population N", default = 24, help = "points per generation" },
  { "--transfer N", default = 0, help = "try the parameters in so many other rooms" },
  { "--jobs N", default = 0, help = "worker processes; 0: one per core" },
  { "LOG", default = "", help = "recorded log; without it one is simulated" },
}

-- Deterministic numbers in [0, 1) for the search (Park and Miller).
local state = options.seed % 2147483646 + 1
local function random()
  state = state * 48271 % 2147483647
  return state / 2147483647
end

local preset = meander.sensor.sonar "real"
preset.ring, preset.distance, preset.speed = 0.31, 0.5, 0.15

local frames, passed
if options.LOG ~= "" then
  frames, passed = log.read(options.LOG)
  if not frames then report.failure(passed) end
else
  local plan = { frames = 600, sensors = 24, rate = options.rate, ring = 0.31, seed = 1001, distance = 0.5, speed = 0.15 }
  plan.sonar = meander.sensor.sonar "real"
  plan.sonar.range_max = 5
  frames, passed = room.record(room.new(4), plan), 0
end
local range_max = log.no_echo(frames)
local count = options.frames > 0 and options.frames or #frames

-- The statistics of one simulated drive with these parameters in this room.
local function simulate(point, number, seed)
  local sonar = meander.sensor.sonar "real"
  for key in pairs(sonar) do
    if point[key] ~= nil then sonar[key] = point[key] end
  end
  sonar.range_max = range_max
  return statistics.of(room.record(room.new(number), {
    frames = count, sensors = #frames[1], rate = options.rate, ring = point.ring, sonar = sonar, seed = seed,
    distance = point.distance, speed = point.speed,
  }), range_max)
end

local function part(list, first, last) return statistics.of(table.move(list, first, last, 1, {}), range_max) end

local real = statistics.of(frames, range_max)
local middle = #frames // 2
local halves = { part(frames, 1, middle), part(frames, middle + 1, #frames) }

local function say(...) if not options.json then print(...) end end
say(("%d frames of %d ranges, no echo reads %.2f m, %d lines passed over"):format(#frames, #frames[1], range_max, passed))

-- Which room? The one where the preset's misfit is least.
local number = options.room
if options.rooms > 0 then
  local seeds = {}
  for i = 1, options.rooms do seeds[i] = i end
  local results = meander.study.trials { seeds = seeds, jobs = options.jobs, trial = function(seed)
    return statistics.misfit(real, simulate(preset, seed, options.seed))
  end }
  local least = math.huge
  for _, result in ipairs(results) do
    if result.ok and result.value < least then number, least = result.seed, result.value end
  end
  say(("of %d rooms number %d fits best: misfit %.3f"):format(options.rooms, number, least))
end

if options.fit == "drive" then search.only_the_drive() end

local fitted
if options.generations > 0 then
  local start = { preset }
  for i = 2, options.population do start[i] = search.near(preset, random) end
  fitted = search.evolve(start, options.generations, function(point)
    return statistics.misfit(real, simulate(point, number, options.seed))
  end, random, options.jobs, function(generation, best)
    if generation % 10 == 0 then say(("generation %3d: misfit %.3f"):format(generation, best)) end
  end)
end

local columns = { { "log", real }, { "half 1", halves[1] }, { "half 2", halves[2] } }
columns[#columns + 1] = { "preset", simulate(preset, number, options.seed) }
columns[#columns + 1] = { "other seed", simulate(preset, number, options.seed + 1) }
if fitted then columns[#columns + 1] = { "fitted", simulate(fitted, number, options.seed) } end

local function print_table()
  local head = ("%-52s"):format("")
  for _, column in ipairs(columns) do head = head .. ("%11s"):format(column[1]) end
  print(head)
  for _, entry in ipairs(statistics.list) do
    local line = ("%-52s"):format(entry[3])
    for _, column in ipairs(columns) do
      local value = column[2][entry[1]]
      line = line .. (entry[1] == "max_run" and ("%11.2f"):format(value) or ("%9.2f %%"):format(100 * value))
    end
    print(line)
  end
  local distances, misfits = ("%-52s"):format("distance of the histograms (halves: from each other)"), ("%-52s"):format("misfit")
  for i, column in ipairs(columns) do
    local other = (i == 2 or i == 3) and columns[5 - i][2] or real
    distances = distances .. ("%11.3f"):format(statistics.distance(column[2], other))
    misfits = misfits .. ("%11.3f"):format(statistics.misfit(column[2], other))
  end
  print(distances)
  print(misfits)
end

local function print_json()
  for _, column in ipairs(columns) do
    local line = { example = "sonar_fit", seed = options.seed, room = number, column = column[1] }
    for _, entry in ipairs(statistics.list) do line[entry[1]] = column[2][entry[1]] end
    line.distance, line.misfit = statistics.distance(column[2], real), statistics.misfit(column[2], real)
    print(json.encode(line))
  end
end

if options.json then print_json() else print_table() end

if fitted then
  for _, p in ipairs(search.parameters) do say(("  %-20s %.4f (preset %.4f)"):format(p[1], fitted[p[1]], preset[p[1]])) end
end

-- Sensor or room? What hardly changes from room to room belongs to the sensor.
if options.transfer > 0 then
  local seeds = {}
  for i = 1, options.transfer do seeds[i] = 1000 + i end
  local results = meander.study.trials { seeds = seeds, jobs = options.jobs, trial = function(seed)
    local s = simulate(fitted or preset, seed, options.seed)
    return { jump_05 = s.jump_05, glitch = s.glitch, max_share = s.max_share, distance = statistics.distance(s, real) }
  end }
  say(("in %d other rooms, nothing refitted: least, median, largest"):format(options.transfer))
  for _, key in ipairs { "jump_05", "glitch", "max_share", "distance" } do
    local values = {}
    for _, result in ipairs(results) do
      if result.ok then values[#values + 1] = result.value[key] end
    end
    table.sort(values)
    local line = { least = values[1], median = meander.study.median(values), largest = values[#values] }
    if options.json then
      print(json.encode { example = "sonar_fit", column = "transfer", statistic = key, n = #values,
        least = line.least, median = line.median, largest = line.largest })
    else
      print(("  %-10s %.4f %.4f %.4f"):format(key, line.least, line.median, line.largest))
    end
  end
end

local path = report.path(options, "sonar_fit.csv")
local file = assert(io.open(path, "w"))
for _, column in ipairs(columns) do
  for _, entry in ipairs(statistics.list) do file:write(("%s,%s,%.17g\n"):format(column[1], entry[1], column[2][entry[1]])) end
end
file:close()
say("table: " .. path)

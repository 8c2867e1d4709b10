-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A map of a recorded run: a table with time, pose and ranges (.csv), or a log of CARMEN with SONAR records. Without a file, a
-- drive through the office is recorded first, and read back.
--
--   ./meander examples/map_log.lua my_run.log --model elfes
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "builds a map of a recorded run",
  { "--model NAME", default = "elfes", values = meander.mapping.models(), help = "sensor model" },
  { "--preset NAME", default = "real", help = "networks: the sonar that their weights were trained for" },
  { "--fusion NAME", default = "viewbin", values = { "viewbin", "bayes" }, help = "how scans are fused" },
  { "--strict", help = "refuse a file with records that cannot be right" },
  { "--range-max METRES", default = 6.477, least = 0.1, most = 1000, help = "a reading from here on is no echo" },
  { "--span-max METRES", default = 200.0, above = 0, help = "poses farther apart are a mistake: the map would be too large" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder for picture and map" },
  { "FILE ...", rest = true, help = "the log, at most one" },
}

local function recorded()
  local path = report.path(options, "map_log_recorded.csv")
  local sim = meander.sim.new { world = meander.world.open "worlds/office.toml", seed = 7, sonar = "real" }
  sim:drive({ navigator = "polar", subgoals = { { 3, 3.7 }, { 6, 4.5 } }, time_limit = 60 }):save(path)
  return path
end

if #options.rest > 1 then report.usage_error("one log expected, got " .. #options.rest) end
local path = options.rest[1] or recorded()
local ok, log = pcall(meander.study.sonar_log, path,
  { bad = options.strict and "refuse" or "skip", range_max = options.range_max })
if not ok then report.failure((tostring(log):gsub("^.-:%d+: [%w_.]+: ", ""))) end
if #log == 0 then report.failure(path .. ": no scan that could be used") end

if log.sonars == 0 then report.usage_error(path .. ": this log has no sonars") end

-- The ring that the file tells of, or that of the platform.
local robot = { preset = "nomad200" }
robot.sonar = log.ring or { count = log.sonars }
local map = report.try(report.usage_error, path, meander.mapping.map, {
  model = options.model, preset = options.preset, fusion = options.fusion, range_max = options.range_max, robot = robot,
})
-- How far apart the poses lie along x and y [m].
local function span()
  local low, high = { x = math.huge, y = math.huge }, { x = -math.huge, y = -math.huge }
  for i = 1, #log do
    local at = log[i].pose
    for _, axis in ipairs { "x", "y" } do
      low[axis], high[axis] = math.min(low[axis], at[axis]), math.max(high[axis], at[axis])
    end
  end
  return high.x - low.x, high.y - low.y
end
local wide, deep = span()
if math.max(wide, deep) > options.span_max then
  report.failure(("%s: poses within %g m expected (--span-max), they span %.6g x %.6g m"):format(
    path, options.span_max, wide, deep))
end

report.try(report.failure, path, function()
  for i = 1, #log do map:update(log[i]) end
end)
local stem = report.path(options, "map_log")
report.try(report.failure, path, map.save, map, stem .. ".yaml")
report.try(report.failure, path, meander.render.save, map, stem .. ".svg")
local counts = log.report
if options.json then
  counts.example, counts.sonars, counts.model = "map_log", log.sonars, options.model
  print(json.encode(counts, {
    "example", "model", "sonars", "lines", "scans", "short_records", "out_of_order", "bad_ranges", "without_pose", "other",
  }))
else
  show(map)
  print(log)
  for _, key in ipairs { "short_records", "out_of_order", "bad_ranges", "without_pose", "other" } do
    if counts[key] > 0 then print(("  %-14s %d"):format(key, counts[key])) end
  end
  print("map: " .. stem .. ".yaml .pgm, picture: " .. stem .. ".svg")
end

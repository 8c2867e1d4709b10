-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Drives through any map that meander can import: meander worlds, ROS maps, floor plans, BARN worlds.
--
--   ./meander examples/drive_map.lua depot.yaml  START_X START_Y  X Y [X Y ...]
--   ./meander examples/drive_map.lua worlds/office.toml  X Y
--
-- Metres in the frame of the map. Of two or more points the first is the start; a single point is the goal, from the start
-- that the map itself names.
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "drives through any importable map; of two or more points the first is the start",
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the picture and the record" },
  { "--heading DEG", default = 0.0, help = "heading at the start, in degrees" },
  { "--resolution M", default = 0.05, help = "metres per pixel of a plain image" },
  { "--unknown HOW", default = "auto", values = { "auto", "free", "occupied" }, help = "unknown cells of a ROS map" },
  { "--index N", default = 0, help = "which world of a BARN file" },
  { "--navigator NAME", default = "potential_field", values = meander.autonomy.navigators(), help = "who drives" },
  { "--robot NAME", default = "nomad200", values = meander.robot.platforms(), help = "kind of robot" },
  { "--sonar NAME", default = "nomad", values = meander.sensor.sonars(), help = "sonar preset" },
  { "--time-limit S", default = 600.0, help = "simulated seconds until the drive is given up" },
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
local world, notes = meander.world.import(options.MAP, {
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
local sim = meander.sim.new {
  world = world, robot = options.robot, sonar = options.sonar, start = start, seed = options.seed,
}
local run = sim:drive { navigator = options.navigator, subgoals = goals, time_limit = options.time_limit }

report.run("drive_map", run, options)

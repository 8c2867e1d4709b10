-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Global and local navigation together: a neural map over the floor plan gives the path, the polar neural map drives along
-- it by sonar. The guide knows the map; the robot starts where the map's frame is its odometry's.
--
--   ./meander examples/drive_planned.lua worlds/office.toml  START_X START_Y  X Y
--   ./meander examples/drive_planned.lua depot.yaml  START_X START_Y  X Y
--
-- Metres in the frame of the map. --hidden adds boxes on the path that the map does not show.
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "plans on a map, drives by sonar; of two points the first is the start",
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures and the record" },
  { "--heading DEG", default = 0.0, help = "heading at the start, in degrees" },
  { "--resolution M", default = 0.05, help = "side of the planner's cells; metres per pixel of a plain image" },
  { "--unknown HOW", default = "auto", values = { "auto", "free", "occupied" }, help = "unknown cells of a ROS map" },
  { "--index N", default = 0, help = "which world of a BARN file" },
  { "--navigator NAME", default = "polar", values = meander.autonomy.navigators(), help = "who drives" },
  { "--planner NAME", default = "neural_map", values = meander.planning.planners(), help = "who plans" },
  { "--robot NAME", default = "nomad200", values = meander.robot.platforms(), help = "kind of robot" },
  { "--sonar NAME", default = "nomad", values = meander.sensor.sonars(), help = "sonar preset" },
  { "--hidden N", default = 0, help = "boxes on the path that the map does not show" },
  { "--time-limit S", default = 600.0, help = "simulated seconds until the drive is given up" },
  { "MAP", help = "map file", default = "worlds/office.toml" },
  { "X Y ...", help = "start and goal in metres", rest = true },
}

local words = options.rest
if #words ~= 4 then report.usage_error("START_X START_Y X Y expected behind the map, got " .. #words .. " words") end
for i = 1, 4 do
  if not tonumber(words[i]) then report.usage_error("a number of metres expected, got '" .. words[i] .. "'") end
end
local start, goal = { tonumber(words[1]), tonumber(words[2]) }, { tonumber(words[3]), tonumber(words[4]) }

local world, notes = meander.world.import(options.MAP, {
  resolution = options.resolution, unknown = options.unknown, index = options.index,
})
for _, line in ipairs(notes) do io.stderr:write(line, "\n") end

local radius = meander.robot.platform(options.robot).body.radius
local map = meander.planning.map { world = world, resolution = options.resolution }
local plan, why = meander.planning.plan { map = map, start = start, target = goal, planner = options.planner, robot_radius = radius + 0.1 }
if not plan then
  plan, why = meander.planning.plan { map = map, start = start, target = goal, planner = options.planner, robot_radius = radius }
end
if not plan then report.failure(why) end
meander.render.save(plan, report.path(options, "drive_planned_plan.svg"))

-- What the map does not know: boxes of 30 cm on the path, evenly spread; where a place is named, there is none.
for i = 1, options.hidden do
  local at = plan.path[math.max(1, i * #plan.path // (options.hidden + 1))]
  pcall(world.add_box, world, { center = { at.x, at.y }, size = { 0.3, 0.3 } })
end

local sim = meander.sim.new {
  world = world, robot = options.robot, sonar = options.sonar, seed = options.seed,
  start = { start[1], start[2], deg(options.heading) },
}
local guide = meander.autonomy.planned_route { map = map, target = goal, planner = options.planner, robot_radius = radius }
-- The guide knows the map: it finds the way out of traps, not the navigator along the walls.
local navigator = options.navigator == "polar" and meander.polar.navigator { robot = options.robot, trap = { escapes = 0 } }
  or options.navigator
local run = sim:drive { navigator = navigator, guide = guide, time_limit = options.time_limit }

report.run("drive_planned", run, options, { planned_length = plan.measures.length, planned_clear = plan.clear })

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A navigator written in Lua: turn towards the subgoal, away from what is near, slower where it is tight. Thirty lines
-- that see nothing but sonar readings and odometry, driven by the same loop as every other navigator.
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "drives with a navigator written in Lua",
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the picture and the record" },
}

-- Bearing of a point, seen from a pose, in (-pi, pi].
local function bearing(pose, point)
  local angle = math.atan(point.y - pose.y, point.x - pose.x) - pose.heading
  return math.atan(math.sin(angle), math.cos(angle))
end

-- A Braitenberg vehicle with a wish: every sonar within a metre pushes to its other side.
local function navigator(observation, subgoal)
  local ranges = observation.sonar
  local turn = 1.2 * bearing(observation.pose, subgoal)
  local ahead = math.huge
  for i = 1, #ranges do
    local direction = 2 * math.pi * (i - 1) / #ranges
    if direction > math.pi then direction = direction - 2 * math.pi end
    if math.abs(direction) < deg(100) then
      local push = math.max(0, 1.0 - ranges[i])
      turn = turn - push * (direction >= 0 and 1 or -1) * math.cos(direction / 2)
    end
    if math.abs(direction) < deg(35) then ahead = math.min(ahead, ranges[i]) end
  end
  local v = math.max(0, math.min(0.5, 0.6 * (ahead - 0.25))) * math.max(0.1, math.cos(turn))
  return v, turn
end

local world = meander.world.open "worlds/clutter.toml"
local sim = meander.sim.new { world = world, robot = "nomad200", seed = options.seed }
local run = sim:drive { navigator = navigator, subgoals = { "goal" }, time_limit = 120 }

report.run("lua_navigator", run, options)

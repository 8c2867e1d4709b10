-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A robot explores a labyrinth by its sonars, three times from the same start: the web of indicators grows, and with it
-- what the robot knows of shorter ways (Dimakov and Golovko, Figures 10 to 12). Each run's way and web are drawn over the
-- world.
--
--   ./meander examples/labyrinth.lua
--   ./meander examples/labyrinth.lua --size 10 --loops 0.15 --seed 2003
local course = require "meander.labyrinth_course"
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "a robot explores a labyrinth in three runs",
  { "--map FILE", default = "worlds/labyrinth.toml", help = "a world with a place 'goal'" },
  { "--size N", default = 0, least = 0, most = 40, help = "cells along each side of one that is made; 0: the map" },
  { "--loops P", default = 0.1, least = 0, most = 1, help = "share of inner walls that are taken away, with --size" },
  { "--seed N", default = 2002, least = 0, help = "of the labyrinth and of all noise" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}
if options.size == 1 then report.usage_error("--size: 0 or 2 to 40 expected, got 1") end

local world
if options.size > 0 then
  world = meander.world.labyrinth { size = options.size, loops = options.loops, seed = options.seed }
else
  world = report.try(report.failure, nil, meander.world.import, options.map)
end
local found, place = pcall(world.get, world, "goal")
if not found then report.failure(options.map .. ": a place 'goal' expected") end
local goal = place.position

local plan = meander.planning.plan {
  map = course.plan_of(world), start = { world.start.x, world.start.y }, target = goal, robot_radius = course.robot.body.radius + 0.05,
}
if not plan then report.failure("no way leads from the start to the goal") end
local shortest = plan.measures.length

local explorer = meander.indicator.sonar_explorer(course.explorer { goal = goal })
local runs = {}
for run = 1, 3 do
  local result = course.run { world = world, explorer = explorer, seed = options.seed * 10 + run, record_every = 5 }
  local picture = report.path(options, ("labyrinth_%d.svg"):format(run))
  meander.render.save(explorer:graph():over(world, result), picture)
  runs[run] = {
    ending = explorer.ending, reason = explorer.reason, walked = explorer.walked, ratio = explorer.walked / shortest,
    indicators = #explorer:graph(), seconds = result.time, contacts = result.contacts, picture = picture,
  }
  if not options.json then
    local r = runs[run]
    print(("run %d: %s after %.1f m in %.0f s, %.2f x the shortest way; %d indicators; %s"):format(
      run, r.ending, r.walked, r.seconds, r.ratio, r.indicators, r.picture))
  end
end
if options.json then
  print(json.encode { seed = options.seed, size = options.size, loops = options.loops, shortest = shortest, runs = runs })
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A robot explores a labyrinth by its sonars, three times from the same start: the web of indicators grows, and with it
-- what the robot knows of shorter ways (Dimakov and Golovko, Figures 10 to 12). Each run's web is drawn over the world.
--
--   ./meander examples/labyrinth.lua
--   ./meander examples/labyrinth.lua --size 10 --loops 0.15 --seed 2003
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "a robot explores a labyrinth in three runs",
  { "--seed N", default = 2002, help = "of the labyrinth and of all noise" },
  { "--size N", default = 6, help = "cells along each side" },
  { "--loops P", default = 0.1, help = "share of inner walls that are taken away" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}
if options.size < 2 or options.size > 40 then report.usage_error("--size: 2 to 40 expected, got " .. options.size) end

local course = require "meander.labyrinth_course"
local cells = meander.indicator.labyrinth { size = options.size, loops = options.loops, seed = options.seed }
local world = cells:world()
local explorer = meander.indicator.sonar_explorer(course.explorer { goal = cells.goal })
local runs = {}
for run = 1, 3 do
  local result = course.run { world = world, explorer = explorer, seed = options.seed * 10 + run }
  local picture = report.path(options, ("labyrinth_%d.svg"):format(run))
  meander.render.save(explorer:graph():over(world), picture)
  runs[run] = {
    ending = explorer.ending, reason = explorer.reason, walked = explorer.walked, ratio = explorer.walked / cells:shortest(),
    indicators = #explorer:graph(), seconds = result.time, contacts = result.contacts, picture = picture,
  }
  if not options.json then
    local r = runs[run]
    print(("run %d: %s after %.1f m in %.0f s, %.2f x the way along the corridors; %d indicators; %s"):format(
      run, r.ending, r.walked, r.seconds, r.ratio, r.indicators, r.picture))
  end
end
if options.json then print(json.encode { seed = options.seed, size = options.size, loops = options.loops, runs = runs }) end

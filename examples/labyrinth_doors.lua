-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Walls change between runs: once the robot knows a route, a passage on it is closed; some runs later it opens again.
--
--   ./meander examples/labyrinth_doors.lua --size 6 --seed 2003
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "a passage closes and opens while a robot explores",
  { "--seed N", default = 2003, help = "of the labyrinth and of all noise" },
  { "--size N", default = 6, help = "cells along each side" },
  { "--loops P", default = 0.2, help = "share of inner walls that are taken away" },
  { "--limit S", default = 3000.0, above = 0, help = "simulated seconds of a run" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}
if options.size < 3 or options.size > 40 then report.usage_error("--size: 3 to 40 expected, got " .. options.size) end
local course = require "meander.labyrinth_course"

local cells = meander.indicator.labyrinth { size = options.size, loops = options.loops, seed = options.seed }
local open = cells:shortest()

-- The passage whose closing makes the shortest way longest, but leaves one.
local door, longest = nil, open
for y = 1, options.size do
  for x = 1, options.size do
    for _, side in ipairs { "east", "north" } do
      local inner = side == "east" and x < options.size or side == "north" and y < options.size
      if inner and cells:open(x, y, side) then
        cells:set_open(x, y, side, false)
        local way = cells:shortest()
        if way and way > longest then door, longest = { x, y, side }, way end
        cells:set_open(x, y, side, true)
      end
    end
  end
end
if not door then report.failure("no passage whose closing leaves a longer way: another --seed, or more --loops") end

local explorer = meander.indicator.sonar_explorer(course.explorer { goal = cells.goal })
local runs = {}
for run = 1, 7 do
  local closed = run == 4 or run == 5
  cells:set_open(door[1], door[2], door[3], not closed)
  course.run { world = cells:world(), explorer = explorer, seed = options.seed * 10 + run, limit = options.limit }
  local shortest = cells:shortest()
  runs[run] = { closed = closed, ending = explorer.ending, walked = explorer.walked, ratio = explorer.walked / shortest, blocked = explorer.blocked }
  if not options.json then
    print(("run %d, the passage is %s: %s after %.1f m, %.2f x the way along the corridors"):format(
      run, closed and "closed" or "open", explorer.ending, explorer.walked, runs[run].ratio))
  end
end
local picture = report.path(options, "labyrinth_doors.svg")
meander.render.save(explorer:graph():over(cells:world()), picture)
if options.json then
  print(json.encode { seed = options.seed, size = options.size, loops = options.loops, open = open, closed = longest, runs = runs })
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The map changes, the path with it: the door of a corridor is shut, the next one too, then there is no way, and at last
-- the first door is open again. After each edit it is told how much of the old path is blocked now.
--
--   ./meander examples/plan_replan.lua
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "plans anew after edits of the map",
  { "--json", help = "one JSON object per step instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
  { "--planner NAME", default = "neural_map", values = meander.planning.planners(), help = "who plans" },
}

-- Two rooms of 4 m x 6 m with a wall between them that has two doors.
local doors = { upper = { { 3.9, 4.4 }, { 4.1, 5.4 } }, lower = { { 3.9, 0.6 }, { 4.1, 1.6 } } }
local map = meander.planning.map { world = meander.world.new { bounds = { { 0, 0 }, { 8, 6 } } }, resolution = 0.05 }
map:block { { 3.9, 0 }, { 4.1, 6 } }
map:block(doors.upper, false)
map:block(doors.lower, false)

local steps = {
  { "both doors are open", function() end },
  { "the upper door is shut", function() map:block(doors.upper) end },
  { "the lower door is shut, too", function() map:block(doors.lower) end },
  { "the upper door is open again", function() map:block(doors.upper, false) end },
  { "a box stands before it", function() map:block { { 2.6, 4.2 }, { 3.0, 5.6 } } end },
}

local before
for i, step in ipairs(steps) do
  step[2]()
  local plan, why = meander.planning.plan {
    map = map, start = { 1, 4 }, target = { 7, 4.5 }, robot_radius = 0.27, planner = options.planner,
  }
  local line = { step = i, edit = step[1], reason = why, solid = 0 }
  if plan then
    line.length, line.clear = plan.measures.length, plan.clear
    line.relaxations_per_cell = plan.statistics.relaxations / math.max(plan.statistics.cells, 1)
    meander.render.save(plan, report.path(options, "plan_replan_" .. i .. ".svg"))
  end
  -- Points of the old path that are solid now.
  for _, p in ipairs(before and before.path or {}) do
    if map:solid(p.x, p.y) then line.solid = line.solid + 1 end
  end
  before = plan
  if options.json then
    print(json.encode(line))
  else
    print(("%d %-30s %s"):format(i, step[1], plan and tostring(plan) or why))
    if line.solid > 0 then print(("  the old path went through %d points that are solid now"):format(line.solid)) end
  end
end
if not options.json then print("pictures: " .. options.out .. "/plan_replan_*.svg") end

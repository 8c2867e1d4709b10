-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Figure 2 of Lagoudakis and Maida (1999) and slides 8 to 13 of their talk: neural maps of 50 x 50 units, r = 1.5,
-- beta = 0.1; one target behind three walls, a target in the middle, and three targets of which the nearest is found.
--
--   ./meander examples/plan_figure2.lua
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "the neural maps of the paper's Figure 2 and of slides 8 to 13",
  { "--json", help = "one JSON object per scene instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}

-- 50 x 50 cells of 10 cm.
local function room(walls)
  local map = meander.planning.map { world = meander.world.new { bounds = { { 0, 0 }, { 5, 5 } } }, resolution = 0.1 }
  for _, wall in ipairs(walls) do map:block(wall) end
  return map
end

local walls = {
  { { 1.0, 2.9 }, { 1.2, 5.0 } },
  { { 1.0, 2.9 }, { 3.0, 3.1 } },
  { { 3.8, 1.4 }, { 4.0, 4.4 } },
}
local boxes = {
  { { 0.8, 3.2 }, { 2.0, 3.4 } }, { { 3.0, 2.9 }, { 3.2, 4.4 } }, { { 1.2, 1.2 }, { 1.4, 2.4 } },
  { { 2.4, 0.8 }, { 3.9, 1.0 } },
}

local scenes = {
  { name = "figure_2", walls = walls, start = { 4.55, 4.55 }, targets = { { 0.55, 4.25 } } },
  { name = "slides_8_to_10", walls = boxes, start = { 4.35, 4.35 }, targets = { { 2.45, 2.25 } } },
  { name = "slides_11_to_13", walls = boxes, start = { 2.55, 2.55 }, targets = { { 0.35, 4.65 }, { 4.55, 4.35 }, { 0.45, 0.45 } } },
}

-- The number of the target that a path ends at.
local function found(path, targets)
  for i, target in ipairs(targets) do
    if math.abs(path[#path].x - target[1]) < 0.051 and math.abs(path[#path].y - target[2]) < 0.051 then return i end
  end
end

for _, scene in ipairs(scenes) do
  local map = room(scene.walls)
  local plan = assert(meander.planning.plan { map = map, start = scene.start, targets = scene.targets })
  local lattice = assert(plan:from(scene.start, "steepest"))
  local best, shortest
  for i, target in ipairs(scene.targets) do
    local straight = assert(meander.planning.plan { map = map, start = scene.start, target = target, planner = "theta_star" })
    if not shortest or straight.measures.length < shortest then best, shortest = i, straight.measures.length end
  end
  meander.render.save(plan, report.path(options, "plan_" .. scene.name .. ".svg"))
  meander.render.save(plan, report.path(options, "plan_" .. scene.name .. ".png"))
  local line = {
    scene = scene.name, targets = #scene.targets, target = found(plan.path, scene.targets), nearest = best,
    length = plan.measures.length, shortest = shortest, lattice_length = lattice.measures.length,
    turning = plan.measures.turning, lattice_turning = lattice.measures.turning, clear = plan.clear,
    dead_units = plan.statistics.dead_units,
  }
  if options.json then
    print(json.encode(line))
  else
    show(plan)
    print(("%s: target %d of %d, %.2f m (shortest %.2f m), turning %.2f rad; from unit to unit %.2f m, %.2f rad"):format(
      scene.name, line.target, line.targets, line.length, shortest, line.turning, line.lattice_length, line.lattice_turning))
    print("picture: " .. options.out .. "/plan_" .. scene.name .. ".svg .png")
  end
end

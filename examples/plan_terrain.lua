-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What weights can tell a neural map (the future work of Lagoudakis and Maida, 1999): difficult ground, a preferred way,
-- and an incline that is hard to climb and easy to descend. Each scene is planned on even ground and with its terrain:
-- the path changes for the reason that is printed.
--
--   ./meander examples/plan_terrain.lua
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "paths over difficult ground, along preferred ways and over inclines",
  { "--json", help = "one JSON object per scene instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}

-- 8 m x 6 m in cells of 10 cm.
local function yard() return meander.planning.map { world = meander.world.new { bounds = { { 0, 0 }, { 8, 6 } } }, resolution = 0.1 } end

local west, east = { 0.75, 3.05 }, { 7.25, 3.05 }
local bog = { { 2.5, 2.0 }, { 5.5, 5.0 } }
local lane = { { 0.5, 0.6 }, { 7.5, 1.4 } }
local slope = { { 2.5, 2.2 }, { 5.5, 6.0 } }

local scenes = {
  { name = "bog", reason = "a bog six times as hard is gone round", start = west, target = east, box = bog,
    terrain = function(map) map:set_difficulty(bog, 6) end },
  { name = "lane", reason = "a lane at a third of the cost is worth the detour", start = west, target = east, box = lane,
    terrain = function(map)
      map:set_difficulty({ { 0, 0 }, { 8, 6 } }, 3)
      map:set_difficulty(lane, 1)
    end },
  { name = "uphill", reason = "the climb costs 1.6 times as much: round the foot of the hill", start = west, target = east,
    box = slope, terrain = function(map) map:set_drag(slope, { 0.6, 0 }) end },
  { name = "downhill", reason = "the descent costs 0.4 times as much: straight over the hill", start = east, target = west,
    box = slope, terrain = function(map) map:set_drag(slope, { 0.6, 0 }) end },
}

-- Share of the path's points within a box.
local function within(path, box)
  local count = 0
  for _, p in ipairs(path) do
    if p.x >= box[1][1] and p.x <= box[2][1] and p.y >= box[1][2] and p.y <= box[2][2] then count = count + 1 end
  end
  return count / #path
end

for _, scene in ipairs(scenes) do
  local map = yard()
  local even = assert(meander.planning.plan { map = map, start = scene.start, target = scene.target })
  scene.terrain(map)
  local plan = assert(meander.planning.plan { map = map, start = scene.start, target = scene.target })
  local cost = {}
  for _, planner in ipairs { "astar", "distance_transform" } do
    cost[planner] = assert(meander.planning.plan { map = map, start = scene.start, target = scene.target, planner = planner })
  end
  meander.render.save(plan, report.path(options, "plan_terrain_" .. scene.name .. ".svg"))
  meander.render.save(map, report.path(options, "plan_terrain_" .. scene.name .. "_map.svg"))
  local line = {
    scene = scene.name, reason = scene.reason, even_length = even.measures.length, length = plan.measures.length,
    even_within = within(even.path, scene.box), within = within(plan.path, scene.box),
    astar_within = within(cost.astar.path, scene.box), least_cost = -cost.distance_transform:value(scene.start[1], scene.start[2]),
    dead_units = plan.statistics.dead_units,
  }
  if options.json then
    print(json.encode(line))
  else
    show(plan)
    print(("%s: %s\n  %.2f m (on even ground %.2f m); share of the path on that ground %.0f %% (%.0f %%; A*: %.0f %%)"):format(
      line.scene, line.reason, line.length, line.even_length, 100 * line.within, 100 * line.even_within,
      100 * line.astar_within))
    print("pictures: " .. options.out .. "/plan_terrain_" .. scene.name .. ".svg, _map.svg")
  end
end

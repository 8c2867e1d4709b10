-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- How far the direction that each kind of weights prefers is off the shortest way's: on maps as the polar navigator meets
-- them in clutter, against Dijkstra over the same units.
--
--   ./meander examples/polar_weights.lua --sectors 32 --seeds 10
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"
local scenes = require "meander.scenes"

local options = require "meander.arguments" {
  about = "angles between the direction read off the polar map and the shortest way's",
  { "--scene NAMES", default = "clutter_10,u_trap,office", help = "where the maps come from" },
  { "--seeds N", default = 5, least = 1, most = 1000000, help = "drives per scene" },
  { "--first-seed S", default = 2000, least = 0, most = 1000000000, help = "their seeds begin here" },
  { "--every N", default = 20, least = 1, most = 1000000, help = "cycles from map to map" },
  { "--cycles N", default = 120, least = 1, most = 1000000, help = "cycles of a drive" },
  { "--sectors N", default = 48, least = 8, most = 256, help = "of the polar map" },
  { "--json", help = "one JSON object per kind of weights instead of text" },
  { "--out DIR", default = "", help = "not used: there are no pictures" },
}
if options.every > options.cycles then
  report.usage_error(("--every: at most --cycles, %d, expected, got %d: no maps would be taken"):format(options.cycles, options.every))
end

local kinds = {
  { "finite volume, kappa 30", { kappa = 30 } }, { "finite volume, kappa 20", { kappa = 20 } },
  { "finite volume, kappa 16", { kappa = 16 } }, { "lattice", { weights = "lattice" } },
  { "euclidean", { weights = "euclidean" } },
}

-- The equilibrium itself, read without hysteresis. Nothing else than the weights differs, so that all see the same map.
local function navigator_with(map)
  local own = { sectors = options.sectors }
  for key, value in pairs(map) do own[key] = value end
  return meander.polar.navigator {
    robot = "nomad200", map = own, solver = { exact = true }, subgoal = { hysteresis = 0 }, trap = { watch = false },
  }
end

-- Ways from the target's unit over free units and their diagonals to those of one ring, by Dijkstra with a heap.
local function ways_to(ring, inside)
  local n, m, spacing = inside.rings, inside.sectors, 2 * math.pi / inside.sectors
  local way, heap = {}, {}
  local function push(length, unit)
    local k = #heap + 1
    heap[k] = { length, unit }
    while k > 1 and heap[k // 2][1] > heap[k][1] do
      heap[k], heap[k // 2] = heap[k // 2], heap[k]
      k = k // 2
    end
  end
  local function pop()
    local top, last = heap[1], table.remove(heap)
    if #heap == 0 then return top end
    heap[1] = last
    local k = 1
    while true do
      local child = 2 * k
      if child < #heap and heap[child + 1][1] < heap[child][1] then child = child + 1 end
      if child > #heap or heap[child][1] >= heap[k][1] then return top end
      heap[k], heap[child], k = heap[child], heap[k], child
    end
  end
  local target = inside.target_ring - 1
  way[target] = 0
  push(0, target)
  while #heap > 0 do
    local length, unit = table.unpack(pop())
    if length <= way[unit] then
      local r, s = unit % n, unit // n
      for dr = -1, 1 do
        for ds = -1, 1 do
          local other_r, other_s = r + dr, (s + ds) % m
          if other_r >= 0 and other_r < n and inside.obstructed[other_r + 1][other_s + 1] == 0 then
            local a, b = inside.radii[r + 1], inside.radii[other_r + 1]
            local longer = length + math.sqrt(math.max(0, a * a + b * b - 2 * a * b * math.cos(ds * spacing)))
            local next_unit = other_s * n + other_r
            if longer < (way[next_unit] or math.huge) then
              way[next_unit] = longer
              push(longer, next_unit)
            end
          end
        end
      end
    end
  end
  local on_ring = {}
  for s = 0, m - 1 do on_ring[s + 1] = way[s * n + ring - 1] or math.huge end
  return on_ring
end

-- The sectors in which a list has its extreme value (several may be equal to within a thousandth of a millimetre).
local function shortest(ways)
  local least = math.min(table.unpack(ways))
  if least == math.huge then return {} end
  local sectors = {}
  for s, way in ipairs(ways) do
    if way < least + 1e-6 then sectors[#sectors + 1] = s end
  end
  return sectors
end

local function degrees_apart(sector, sectors)
  local least = math.huge
  for _, other in ipairs(sectors) do
    local apart = math.abs(sector - other)
    least = math.min(least, math.min(apart, options.sectors - apart) * 360 / options.sectors)
  end
  return least
end

local off = {}
for i in ipairs(kinds) do off[i] = {} end
local maps = 0

local function look(navigators, ring_at)
  local first = navigators[1]:inspect()
  if not first.subgoal then return end
  local ring = 1
  while ring < first.target_ring and first.radii[ring] < ring_at do ring = ring + 1 end
  local sectors = shortest(ways_to(ring, first))
  if #sectors == 0 then return end
  maps = maps + 1
  for i, navigator in ipairs(navigators) do
    local inside = navigator:inspect()
    local best = 1
    for s = 2, inside.sectors do
      if inside.activation[ring][s] > inside.activation[ring][best] then best = s end
    end
    off[i][#off[i] + 1] = degrees_apart(best, sectors)
  end
end

for _, name in ipairs(candidates.chosen(options.scene, scenes.names(), "scene")) do
  for seed = options.first_seed, options.first_seed + options.seeds - 1 do
    local scene = scenes.make(name, seed)
    if scene then
      local sim = meander.sim.new { world = scene.world, start = scene.start, robot = "nomad200", seed = seed }
      local navigators = {}
      for i, kind in ipairs(kinds) do navigators[i] = navigator_with(kind[2]) end
      local goal = scene.subgoals[#scene.subgoals]
      for cycle = 1, options.cycles do
        local v, w, status
        for i, navigator in ipairs(navigators) do
          local own_v, own_w, own_status = navigator:step(sim.observation, goal)
          if i == 1 then v, w, status = own_v, own_w, own_status end
        end
        if status ~= "driving" then break end
        if cycle % options.every == 0 then look(navigators, 0.2) end
        sim:step(v, w)
      end
    end
  end
end

if maps == 0 then report.failure "no maps were taken: no way to the subgoal in any, or the seeds have no such scene" end

local function quantile(values, share)
  table.sort(values)
  return values[math.max(1, math.ceil(share * #values))]
end

for i, kind in ipairs(kinds) do
  local line = {
    weights = kind[1], sectors = options.sectors, maps = maps, median = quantile(off[i], 0.5), p90 = quantile(off[i], 0.9),
  }
  if options.json then
    print(json.encode(line, { "weights", "sectors", "maps", "median", "p90" }))
  else
    print(("%-24s %5.1f / %5.1f degrees off, median / 90 %% of %d maps"):format(kind[1], line.median, line.p90, maps))
  end
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What a local map is worth to who drives: the polar navigator with its memory of readings and with the map in its place; the
-- potential field, alone and with the map as a safety device; and a reckless one, which drives straight at its goal whatever
-- stands in between. On the scenes of local navigation, and at a wall and a thin pole.
--
--   ./meander examples/map_scenes.lua --seeds 40 --scene office,clutter_10
--   ./meander examples/map_scenes.lua --scene wall,pole --way reckless,reckless_safety
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"
local scenes = require "meander.scenes"

local options = require "meander.arguments" {
  about = "measures what a local map is worth to navigators",
  { "--scene NAMES", default = "u_trap,l_corner,office,doors,clutter_10", help = "with commas, or all" },
  { "--way NAMES", default = "polar,polar_map,field,field_safety", help = "those, reckless, reckless_safety, or all" },
  { "--model NAME", default = "elfes", values = meander.mapping.models(), help = "sensor model of the maps" },
  { "--preset NAME", default = "real", help = "networks: the sonar that their weights were trained for" },
  { "--fusion NAME", default = "viewbin", values = { "viewbin", "bayes" }, help = "how scans are fused" },
  { "--sonar NAME", default = "nomad", values = { "ideal", "nomad", "real" }, help = "sonar preset of the robot" },
  { "--occupied P", default = 0.5, least = 0.05, most = 0.95, help = "cells of at least this probability are obstacles" },
  { "--seeds N", default = 20, least = 1, help = "trials per scene" },
  { "--first-seed S", default = 2000, least = 0, help = "their seeds begin here" },
  { "--json", help = "one JSON object per scene and way" },
  { "--jobs N", default = 0, help = "worker processes; 0: one per core" },
  { "--out DIR", default = "", help = "folder for pictures of the drives with the first seed; none when empty" },
}

local map = { model = options.model, preset = options.preset, fusion = options.fusion }
local function field() return meander.polar.potential_field {} end
local function reckless() return meander.polar.potential_field { repulsion = 0, caution = 0, margin = 0 } end
local function safe(navigator)
  return meander.autonomy.map_safety(navigator, { map = map, occupied = options.occupied })
end
local makers = {
  polar = function() return meander.polar.navigator {} end,
  polar_map = function() return meander.autonomy.map_navigator { map = map, occupied = options.occupied } end,
  field = field,
  field_safety = function() return safe(field()) end,
  reckless = reckless,
  reckless_safety = function() return safe(reckless()) end,
}
local all_ways = { "polar", "polar_map", "field", "field_safety", "reckless", "reckless_safety" }
local ways = candidates.chosen(options.way, all_ways, "way")

-- Even shares of [-1, 1] over the seeds: multiples of the golden ratio.
local function share(seed) return 2 * (seed * 0.6180339887498949 % 1) - 1 end

-- The goal is behind what stands in the way: a wall met at up to 60 degrees, a pole 6 cm thick met up to 0.2 m beside the middle.
local function obstructed(angle, beside, add)
  local world = meander.world.new { bounds = { { 0, 0 }, { 10, 10 } } }
  add(world)
  local x, y = 5 - 2.5 * math.cos(angle), 5 + beside - 2.5 * math.sin(angle)
  local goal = { 5 + 2 * math.cos(angle), 5 + beside + 2 * math.sin(angle) }
  return { world = world, start = { x, y, angle }, subgoals = { goal }, time_limit = 30 }
end
local own = {
  wall = function(seed)
    return obstructed(share(seed) * math.pi / 3, 0, function(world) world:add_wall { points = { { 5, 0 }, { 5, 10 } } } end)
  end,
  pole = function(seed)
    return obstructed(0, 0.2 * share(seed), function(world) world:add_disc { center = { 5, 5 }, radius = 0.03 } end)
  end,
}

local function drive(name, way, seed)
  local scene = own[name] and own[name](seed) or scenes.make(name, seed)
  if not scene then return { passed_over = true } end
  local picture = options.out ~= "" and seed == options.first_seed
  local sim = meander.sim.new { world = scene.world, start = scene.start, sonar = options.sonar, seed = seed }
  local run = sim:drive {
    navigator = makers[way](), subgoals = scene.subgoals, hand_over = scene.hand_over, when_trapped = "insist",
    time_limit = scene.time_limit, record_every = picture and 1 or 0,
  }
  if picture then run:save(report.path(options, ("map_scenes_%s_%s.svg"):format(name, way))) end
  return {
    success = run.success, faults = run.fault_contacts, time = run.time, clearance = run.clearance_min,
    cycle_us = 1e6 * run.cpu_per_cycle,
  }
end

local keys = { "scene", "way", "model", "sonar", "n", "reached", "fault_contacts", "with_contacts", "time_median", "clearance_median", "cycle_us_median" }

local known = table.move({ "wall", "pole" }, 1, 2, #scenes.names() + 1, scenes.names())
for _, name in ipairs(candidates.chosen(options.scene, known, "scene")) do
  for _, way in ipairs(ways) do
    local seeds, runs = {}, {}
    for i = 1, options.seeds do seeds[i] = options.first_seed + i - 1 end
    for _, result in ipairs(meander.study.trials { seeds = seeds, jobs = options.jobs, trial = function(seed)
      return drive(name, way, seed)
    end }) do
      if not result.ok then report.failure(("%s, %s, seed %d: %s"):format(name, way, result.seed, result.error)) end
      if not result.value.passed_over then runs[#runs + 1] = result.value end
    end
    local arrived = function(run) return run.success end
    local times = candidates.column(runs, "time", arrived)
    local line = {
      scene = name, way = way, model = options.model, sonar = options.sonar, n = #runs,
      reached = #times,
      fault_contacts = math.tointeger(candidates.sum(candidates.column(runs, "faults"))),
      with_contacts = #candidates.column(runs, "faults", function(run) return run.faults > 0 end),
      time_median = #times > 0 and candidates.rounded((candidates.median(times)), 2) or nil,
      clearance_median = candidates.rounded((candidates.median(candidates.column(runs, "clearance"))), 3),
      cycle_us_median = candidates.rounded((candidates.median(candidates.column(runs, "cycle_us"))), 1),
    }
    if options.json then
      print(json.encode(line, keys))
    else
      print(("%-12s %-13s reached %2d of %2d, own contacts %3d in %2d runs, %8s, clearance %.3f m, %6.1f us a cycle"):format(
        name, way, line.reached, line.n, line.fault_contacts, line.with_contacts, line.time_median and ("%.1f s"):format(line.time_median) or "-", line.clearance_median, line.cycle_us_median))
    end
  end
end

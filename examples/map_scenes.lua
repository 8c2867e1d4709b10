-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What a local map is worth to who drives: the polar navigator with its memory of readings and with the map in its place, and a
-- navigator that bumps into things, alone and with the map as a safety device, on the scenes of local navigation.
--
--   ./meander examples/map_scenes.lua --seeds 40 --scene office,clutter_10
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"
local scenes = require "meander.scenes"

local options = require "meander.arguments" {
  about = "measures what a local map is worth to navigators",
  { "--scene NAMES", default = "u_trap,l_corner,office,doors,clutter_10", help = "with commas, or all" },
  { "--way NAMES", default = "all", help = "polar, polar_map, field, field_safety, or all" },
  { "--model NAME", default = "elfes", values = meander.mapping.models(), help = "sensor model of the maps" },
  { "--preset NAME", default = "real", help = "networks: the sonar that their weights were trained for" },
  { "--fusion NAME", default = "viewbin", values = { "viewbin", "bayes" }, help = "how scans are fused" },
  { "--sonar NAME", default = "nomad", values = { "ideal", "nomad", "real" }, help = "sonar preset of the robot" },
  { "--occupied P", default = 0.5, help = "cells of at least this probability are obstacles" },
  { "--seeds N", default = 20, help = "trials per scene" },
  { "--first-seed S", default = 2000, help = "their seeds begin here" },
  { "--json", help = "one JSON object per scene and way" },
  { "--jobs N", default = 0, help = "worker processes; 0: one per core" },
  { "--out DIR", default = "", help = "not used" },
}

local map = { model = options.model, preset = options.preset, fusion = options.fusion }
local makers = {
  polar = function() return meander.polar.navigator {} end,
  polar_map = function() return meander.autonomy.map_navigator { map = map, occupied = options.occupied } end,
  field = function() return meander.polar.potential_field {} end,
  field_safety = function() return meander.autonomy.map_safety(meander.polar.potential_field {}, { map = map, occupied = options.occupied }) end,
}
local ways = candidates.chosen(options.way, { "polar", "polar_map", "field", "field_safety" }, "way")

local function drive(name, way, seed)
  local scene = scenes.make(name, seed)
  if not scene then return { passed_over = true } end
  local sim = meander.sim.new { world = scene.world, start = scene.start, sonar = options.sonar, seed = seed }
  local run = sim:drive {
    navigator = makers[way](), subgoals = scene.subgoals, hand_over = scene.hand_over, when_trapped = "insist",
    time_limit = scene.time_limit, record_every = 0,
  }
  return {
    success = run.success, faults = run.fault_contacts, time = run.time, clearance = run.clearance_min,
    cycle_us = 1e6 * run.cpu_per_cycle,
  }
end

local keys = { "scene", "way", "model", "sonar", "n", "reached", "fault_contacts", "time_median", "clearance_median", "cycle_us_median" }

for _, name in ipairs(candidates.chosen(options.scene, scenes.names(), "scene")) do
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
      time_median = #times > 0 and candidates.rounded((candidates.median(times)), 2) or nil,
      clearance_median = candidates.rounded((candidates.median(candidates.column(runs, "clearance"))), 3),
      cycle_us_median = candidates.rounded((candidates.median(candidates.column(runs, "cycle_us"))), 1),
    }
    if options.json then
      print(json.encode(line, keys))
    else
      print(("%-12s %-13s reached %2d of %2d, own contacts %3d, %8s, clearance %.3f m, %6.1f us a cycle"):format(
        name, way, line.reached, line.n, line.fault_contacts, line.time_median and ("%.1f s"):format(line.time_median) or "-", line.clearance_median, line.cycle_us_median))
    end
  end
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A robot drives through a world while every sensor model builds a map of the same scans: the maps side by side, as pictures and
-- as ROS maps, and a table of how good they are.
--
--   ./meander examples/map_building.lua --world worlds/office.toml --sonar real
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "builds maps of a world by sonar, with every sensor model",
  { "--world FILE", default = "worlds/office.toml", help = "where it drives; named places are its subgoals" },
  { "--sonar NAME", default = "ideal", values = { "ideal", "nomad", "real" }, help = "sonar preset" },
  { "--model NAMES", default = "all", help = "sensor models, with commas, or all" },
  { "--fusion NAME", default = "viewbin", values = { "viewbin", "bayes" }, help = "how scans are fused" },
  { "--seed N", default = 7, help = "seed of the sonar's noise" },
  { "--time SECONDS", default = 120.0, above = 0, help = "the drive ends then" },
  { "--json", help = "one JSON object per model instead of text" },
  { "--out DIR", default = "out", help = "folder for pictures and maps" },
}

local models = candidates.chosen(options.model, meander.mapping.models(), "model")
local world = meander.world.open(options.world)
local sim = meander.sim.new { world = world, sonar = options.sonar, seed = options.seed }
local places = world:places()
if #places == 0 then report.failure(options.world .. ": has no named places to drive to") end

-- Networks are trained for the sonars of the paper's simulator and for real ones.
local trained_for = options.sonar == "real" and "real" or "ideal"
local maps, sums, counts, scored = {}, {}, {}, false
for _, model in ipairs(models) do
  maps[model] = meander.mapping.map { model = model, preset = trained_for, fusion = options.fusion }
  sums[model], counts[model] = { ce = 0, auc = 0, error = 0 }, { ce = 0, auc = 0, error = 0 }
end

-- Scores of the local map are means over the drive, each over the moments that have it: where nothing is in sight there is
-- no cross-entropy.
local function score()
  scored = true
  for _, model in ipairs(models) do
    local now, sum, count = meander.study.map_score(maps[model], sim), sums[model], counts[model]
    for key in pairs(sum) do
      if now[key] == now[key] then sum[key], count[key] = sum[key] + now[key], count[key] + 1 end
    end
  end
end

-- Nothing where there was no moment to score.
local function mean(model, key)
  local count = counts[model][key]
  return count > 0 and sums[model][key] / count or nil
end

local subgoals, cycles = {}, 0
for i, place in ipairs(places) do subgoals[i] = place.name end
local run = sim:drive {
  navigator = "polar", subgoals = subgoals, when_trapped = "skip", time_limit = options.time,
  on_step = function()
    cycles = cycles + 1
    for _, map in pairs(maps) do map:update(sim.observation) end
    if cycles % 10 == 0 then score() end
  end,
}
if not scored then score() end

for i, model in ipairs(models) do
  local stem = report.path(options, "map_building_" .. model)
  maps[model]:save(stem .. ".yaml")
  meander.render.save(maps[model], stem .. ".svg")
  local ce, auc, error_m = mean(model, "ce"), mean(model, "auc"), mean(model, "error")
  if options.json then
    local rounded = candidates.rounded
    print(json.encode(
      { example = "map_building", model = model, fusion = options.fusion, sonar = options.sonar, scans = maps[model].scans,
        ce = ce and rounded(ce, 4), auc = auc and rounded(auc, 4), error_cm = error_m and rounded(100 * error_m, 2) },
      { "example", "model", "fusion", "sonar", "scans", "ce", "auc", "error_cm" }))
  else
    if i == 1 then
      print(("%.0f s, %.1f m, %d scans, fusion %s"):format(run.time, run.length, maps[model].scans, options.fusion))
      print(("%-8s %8s %8s %10s"):format("model", "ce", "auc", "error [cm]"))
    end
    local function shown(form, value) return value and form:format(value) or "-" end
    print(("%-8s %8s %8s %10s   %s.svg .yaml .pgm"):format(
      model, shown("%.3f", ce), shown("%.3f", auc), shown("%.1f", error_m and 100 * error_m), stem))
  end
end
if not options.json then show(maps[models[1]]) end

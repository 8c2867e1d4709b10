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
  { "--time SECONDS", default = 120.0, help = "the drive ends then" },
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
local maps, sums, count = {}, {}, 0
for _, model in ipairs(models) do
  maps[model] = meander.mapping.map { model = model, preset = trained_for, fusion = options.fusion }
  sums[model] = { ce = 0, auc = 0, error = 0 }
end

-- Scores of the local map are means over the drive.
local function score()
  count = count + 1
  for _, model in ipairs(models) do
    local now, sum = meander.study.map_score(maps[model], sim), sums[model]
    for key in pairs(sum) do
      if now[key] == now[key] then sum[key] = sum[key] + now[key] end
    end
  end
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
if count == 0 then score() end

for i, model in ipairs(models) do
  local stem = report.path(options, "map_building_" .. model)
  maps[model]:save(stem .. ".yaml")
  meander.render.save(maps[model], stem .. ".svg")
  local ce, auc, error_cm = sums[model].ce / count, sums[model].auc / count, 100 * sums[model].error / count
  if options.json then
    local rounded = candidates.rounded
    print(json.encode(
      { example = "map_building", model = model, fusion = options.fusion, sonar = options.sonar, scans = maps[model].scans,
        ce = rounded(ce, 4), auc = rounded(auc, 4), error_cm = rounded(error_cm, 2) },
      { "example", "model", "fusion", "sonar", "scans", "ce", "auc", "error_cm" }))
  else
    if i == 1 then
      print(("%.0f s, %.1f m, %d scans, fusion %s"):format(run.time, run.length, maps[model].scans, options.fusion))
      print(("%-8s %8s %8s %10s"):format("model", "ce", "auc", "error [cm]"))
    end
    print(("%-8s %8.3f %8.3f %10.1f   %s.svg .yaml .pgm"):format(model, ce, auc, error_cm, stem))
  end
end
if not options.json then show(maps[models[1]]) end

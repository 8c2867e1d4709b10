-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The experiments of [CN] with every sensor model on the same scans: errors by direction (Figure 6), robustness, adaptability,
-- rotation, and the map after a drive (fused). Figures are means over rooms with 95 % intervals, and differences in pairs.
--
--   ./meander examples/map_experiments.lua --seeds 20 --preset real
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"
local rooms = require "meander.sonar_rooms"

local options = require "meander.arguments" {
  about = "repeats the experiments of [CN] on maps of sonar readings",
  { "--seeds N", default = 12, least = 1, help = "rooms per preset" },
  { "--first-seed S", default = 2000, least = 0, help = "their seeds begin here; nothing was trained or tuned on 1000 and more" },
  { "--preset NAMES", default = "ideal,real", help = "sonar presets, with commas" },
  { "--model NAMES", default = "all", help = "sensor models, with commas, or all" },
  { "--experiment NAMES", default = "all", help = "direction, robustness, adaptability, rotation, fused, or all" },
  { "--against NAME", default = "elfes", values = meander.mapping.models(),
    help = "the one of --model that the others are compared with in pairs" },
  { "--places N", default = 3, least = 1, help = "places per room where the robot stands" },
  { "--drive SECONDS", default = 40.0, above = 0, help = "length of the drive" },
  { "--threshold P", default = "0.5",
    help = "probability above which a cell is an obstacle, for errors by direction; also by model: nn4=0.95,ros=0.5" },
  { "--jobs N", default = 0, help = "worker processes; 0: one per core" },
  { "--json", help = "one JSON object per experiment, preset and model" },
  { "--out DIR", default = "", help = "folder for the reliability curves; none when empty" },
}

local kScans = 15 -- of a robot that stands, as in the paper
local kTurn = math.pi / 16 -- half the pitch of 16 sonars: the worst there is; the paper's 66 degrees are nearly 3 pitches
local kMarked = 0.5

local models = candidates.chosen(options.model, meander.mapping.models(), "model")
local presets = candidates.chosen(options.preset, { "ideal", "real" }, "preset")
local known = { "direction", "robustness", "adaptability", "rotation", "fused" }
local experiments = candidates.chosen(options.experiment, known, "experiment")

-- Thresholds by model: one number for all, or one for each that is named and 0.5 for the others.
local function thresholds_in(text)
  local thresholds = setmetatable({}, { __index = function() return tonumber(text) or 0.5 end })
  local function put(value, word)
    local p = tonumber(value)
    if not p or p < 0.01 or p > 0.99 then
      report.usage_error("--threshold: a probability from 0.01 to 0.99 or model=probability expected, got '" .. word .. "'")
    end
    return p
  end
  if tonumber(text) then put(text, text) return thresholds end
  for word in (text .. ","):gmatch "([^,]*)," do
    local name, value = word:match "^%s*([%w_]+)%s*=%s*(%S+)%s*$"
    if not name then put(nil, word) end
    local p = put(value, word)
    for _, model in ipairs(candidates.chosen(name, meander.mapping.models(), "model")) do thresholds[model] = p end
  end
  return thresholds
end
local thresholds = thresholds_in(options.threshold)

local wanted = {}
for _, name in ipairs(experiments) do wanted[name] = true end

-- A map of every model, all of which see the same scans.
local function maps_of(preset, fusion)
  local maps = {}
  for _, model in ipairs(models) do
    maps[model] = meander.mapping.map { model = model, preset = preset, fusion = fusion, global = false }
  end
  return maps
end

local function update(maps, observation)
  for _, map in pairs(maps) do map:update(observation) end
end

local function stand(sim, maps, scans)
  for _ = 1, scans do update(maps, sim:step(0, 0)) end
end

-- Adds figures to those of a model: lists of values, one per place.
local function note(results, experiment, fusion, model, figures)
  local key = table.concat({ experiment, fusion, model }, " ")
  results[key] = results[key] or {}
  for name, value in pairs(figures) do
    local list = results[key][name] or {}
    results[key][name] = list
    if value == value then list[#list + 1] = value end
  end
end

-- Share of the cells seen (where `truth` is not 0) whose class differs.
local function flipped(truth, before, after)
  local cells, changed = 0, 0
  for i = 1, #truth do
    if truth[i] > 0 then
      cells = cells + 1
      if (before[i] > kMarked) ~= (after[i] > kMarked) then changed = changed + 1 end
    end
  end
  return cells > 0 and changed / cells or 0 / 0
end

local function copies(maps)
  local matrices = {}
  for model, map in pairs(maps) do matrices[model] = map:matrix("local"):all() end
  return matrices
end

local function score_figures(score)
  return { error_cm = 100 * score.error, ce = score.ce, brier = score.brier, auc = score.auc, ece = score.ece }
end

-- One scan against many, and then a turn: the class of a cell should not change.
local function standing(results, room, preset, seed, place)
  local maps = maps_of(preset, "viewbin")
  local function sim_at(turn)
    local start = { place[1], place[2], place[3] + turn }
    return meander.sim.new { world = room.world, start = start, sonar = preset, seed = seed }
  end
  local sim = sim_at(0)
  stand(sim, maps, 1)
  local truth = meander.study.map_truth(maps[models[1]], sim):all()
  local first = copies(maps)
  for _, model in ipairs(models) do
    note(results, "robustness", "viewbin", model, score_figures(meander.study.map_score(maps[model], sim, { threshold = thresholds[model] })))
  end
  stand(sim, maps, kScans - 1)
  local last = copies(maps)
  for _, model in ipairs(models) do
    note(results, "robustness", "viewbin", model, { flipped = flipped(truth, first[model], last[model]) })
  end
  local turned = sim_at(kTurn)
  stand(turned, maps, kScans)
  local after = copies(maps)
  for _, model in ipairs(models) do
    note(results, "rotation", "viewbin", model, { flipped = flipped(truth, last[model], after[model]) })
  end
end

-- How much of the front is marked.
local function marked(front, cells)
  local count = 0
  for _, i in ipairs(front) do
    if cells[i] > kMarked then count = count + 1 end
  end
  return count / #front
end

-- Scans until `done` holds for each model; one more than there were where it never does.
local function scans_until(sim, maps, front, done)
  local scans = {}
  for scan = 1, kScans do
    stand(sim, maps, 1)
    for model, cells in pairs(copies(maps)) do
      if not scans[model] and done(marked(front, cells)) then scans[model] = scan end
    end
  end
  for _, model in ipairs(models) do scans[model] = scans[model] or kScans + 1 end
  return scans
end

-- A pole appears near the robot and goes away again.
local function adaptability(results, room, preset, seed, place)
  local maps = maps_of(preset, "viewbin")
  local sim = meander.sim.new { world = room.world:fork(), start = place, sonar = preset, seed = seed }
  stand(sim, maps, kScans)
  local before = meander.study.map_truth(maps[models[1]], sim):all()
  local bearing, distance = room.random(-math.pi, math.pi), room.random(0.6, 1.2)
  local radius = room.random(0.08, 0.2)
  local at = { place[1] + distance * math.cos(bearing), place[2] + distance * math.sin(bearing) }
  local clear = { world = sim.world, from = { place[1], place[2] }, heading = bearing, range = distance + radius + 0.2 }
  if meander.sensor.ray(clear) then return end
  local pole = sim.world:add_disc { center = at, radius = radius }
  stand(sim, maps, 1)
  local after, front = meander.study.map_truth(maps[models[1]], sim):all(), {}
  for i = 1, #after do
    if after[i] == 2 and before[i] ~= 2 then front[#front + 1] = i end
  end
  if #front == 0 then return end
  local at_once = copies(maps)
  local half = scans_until(sim, maps, front, function(share) return share >= 0.5 end)
  local there = copies(maps)
  sim.world:remove(pole)
  local clear_after = scans_until(sim, maps, front, function(share) return share <= 0.1 end)
  for _, model in ipairs(models) do
    local figures = { scans_to_half = marked(front, at_once[model]) >= 0.5 and 1 or half[model] + 1 }
    figures.first_update = marked(front, at_once[model])
    if marked(front, there[model]) >= 0.5 then figures.scans_to_clear = clear_after[model] end
    note(results, "adaptability", "viewbin", model, figures)
  end
end

-- The map at the end of a drive by both rules; every few seconds it is scored.
local function driving(results, room, preset, seed)
  local both = { viewbin = maps_of(preset, "viewbin"), bayes = maps_of(preset, "bayes") }
  local subgoals = {}
  local start = room:place()
  for i = 1, 20 do
    local place = room:place()
    subgoals[i] = { place[1], place[2] }
  end
  local sim = meander.sim.new { world = room.world, start = start, sonar = preset, seed = seed }
  local cycles = 0
  sim:drive {
    navigator = "vfh_plus", subgoals = subgoals, when_trapped = "skip", time_limit = options.drive, record_every = 0,
    on_step = function()
      cycles = cycles + 1
      for _, maps in pairs(both) do update(maps, sim.observation) end
      if cycles % 20 > 0 then return end
      for fusion, maps in pairs(both) do
        for _, model in ipairs(models) do
          local score = meander.study.map_score(maps[model], sim, { threshold = thresholds[model] })
          local figures = score_figures(score)
          note(results, "fused", fusion, model, figures)
          note(results, "direction", fusion, model,
            { error_cm = figures.error_cm, missed = score.missed, phantom = score.phantom })
          if fusion == "viewbin" then results.bins = results.bins or {} end
          if results.bins and fusion == "viewbin" then
            local bins = results.bins[model] or {}
            results.bins[model] = bins
            for k, bin in ipairs(score.reliability) do
              local sum = bins[k] or { 0, 0, 0 }
              bins[k] = { sum[1] + bin.weight, sum[2] + bin.predicted, sum[3] + bin.occupied }
            end
          end
        end
      end
    end,
  }
end

local function mean(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value end
  return #list > 0 and sum / #list or nil
end

-- A room's figures, one number each: the mean over its places or moments.
local function trial(preset, seed)
  local room, results = rooms.make(seed), {}
  if wanted.robustness or wanted.rotation or wanted.adaptability then
    for k = 1, options.places do
      local place = room:place()
      if wanted.robustness or wanted.rotation then standing(results, room, preset, 10 * seed + k, place) end
      if wanted.adaptability then adaptability(results, room, preset, 10 * seed + k, place) end
    end
  end
  if wanted.direction or wanted.fused then driving(results, room, preset, seed) end
  local bins = results.bins
  results.bins = nil
  local means = {}
  for key, figures in pairs(results) do
    means[key] = {}
    for name, list in pairs(figures) do means[key][name] = mean(list) end
  end
  return { means = means, bins = bins }
end

local figure_names = {
  direction = { "error_cm", "missed", "phantom" },
  robustness = { "flipped", "ce", "brier", "auc" },
  adaptability = { "scans_to_half", "scans_to_clear", "first_update" },
  rotation = { "flipped" },
  fused = { "ce", "brier", "auc", "ece", "error_cm" },
}

-- The values of a figure over the rooms that have it for all models named.
local function column(trials, experiment, fusion, name, one, other)
  local a, b = {}, {}
  for _, result in ipairs(trials) do
    local of = result.means
    local x = of[table.concat({ experiment, fusion, one }, " ")]
    local y = of[table.concat({ experiment, fusion, other or one }, " ")]
    if x and y and x[name] and y[name] then
      a[#a + 1], b[#b + 1] = x[name], y[name]
    end
  end
  return a, b
end

local function rounded(value) return candidates.rounded(value, 4) end

local function row(trials, experiment, preset, fusion, model)
  local line = { experiment = experiment, preset = preset, model = model, fusion = fusion, rooms = #trials }
  local keys = { "experiment", "preset", "model", "fusion", "rooms" }
  local function put(key, value)
    line[key] = value
    keys[#keys + 1] = key
  end
  for k, name in ipairs(figure_names[experiment]) do
    local values = column(trials, experiment, fusion, name, model)
    if #values > 0 then
      local value, low, high = meander.study.bootstrap_mean(values)
      put(name, rounded(value))
      put(name .. "_low", rounded(low))
      put(name .. "_high", rounded(high))
      put(name .. "_n", #values)
      if k == 1 and model ~= options.against then
        local a, b = column(trials, experiment, fusion, name, model, options.against)
        if #a > 0 then
          local difference, least, most = meander.study.compare(a, b)
          put("against", options.against)
          put("difference", rounded(difference))
          put("difference_low", rounded(least))
          put("difference_high", rounded(most))
          put("difference_n", #a)
        end
      end
    end
  end
  return line, keys
end

local function say(line)
  local text = ("%-13s %-6s %-8s %-7s"):format(line.experiment, line.preset, line.model, line.fusion)
  for _, name in ipairs(figure_names[line.experiment]) do
    if line[name] then
      text = text .. (" %s %.4g (%.4g, %.4g)"):format(name, line[name], line[name .. "_low"], line[name .. "_high"])
      if line[name .. "_n"] < line.rooms then text = text .. " in " .. line[name .. "_n"] .. " of " .. line.rooms end
    end
  end
  if line.difference then
    text = text .. (" | against %s %+.3g (%+.3g, %+.3g)"):format(
      line.against, line.difference, line.difference_low, line.difference_high)
  end
  print(text)
end

-- How often cells of about the same probability are occupied, by model.
local function save_reliability(trials, preset)
  local path = report.path(options, "reliability_" .. preset .. ".csv")
  local lines = { "model,bin,weight,predicted,occupied" }
  for _, model in ipairs(models) do
    local sums = {}
    for _, result in ipairs(trials) do
      for k, bin in ipairs(result.bins and result.bins[model] or {}) do
        sums[k] = sums[k] or { 0, 0, 0 }
        for i = 1, 3 do sums[k][i] = sums[k][i] + bin[i] end
      end
    end
    for k, bin in ipairs(sums) do
      lines[#lines + 1] = ("%s,%d,%.6f,%.4f,%.4f"):format(
        model, k, bin[1], bin[1] > 0 and bin[2] / bin[1] or 0, bin[1] > 0 and bin[3] / bin[1] or 0)
    end
  end
  local file <close> = assert(io.open(path, "w"))
  file:write(table.concat(lines, "\n"), "\n")
  return path
end

for _, preset in ipairs(presets) do
  local seeds = {}
  for i = 1, options.seeds do seeds[i] = options.first_seed + i - 1 end
  local trials = {}
  for _, result in ipairs(meander.study.trials { seeds = seeds, jobs = options.jobs, trial = function(seed)
    return trial(preset, seed)
  end }) do
    if not result.ok then report.failure(("%s, seed %d: %s"):format(preset, result.seed, result.error)) end
    trials[#trials + 1] = result.value
  end
  for _, experiment in ipairs(experiments) do
    local rules = (experiment == "fused" or experiment == "direction") and { "viewbin", "bayes" } or { "viewbin" }
    for _, fusion in ipairs(rules) do
      for _, model in ipairs(models) do
        local line, keys = row(trials, experiment, preset, fusion, model)
        if options.json then print(json.encode(line, keys)) else say(line) end
      end
    end
  end
  if options.out ~= "" and (wanted.fused or wanted.direction) then
    local path = save_reliability(trials, preset)
    if not options.json then print("reliability: " .. path) end
  end
end

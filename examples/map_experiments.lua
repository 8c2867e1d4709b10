-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The experiments of [CN] with every sensor model on the same scans: errors by direction (Figure 6), robustness, adaptability,
-- rotation, the map after a drive (fused), a robot that goes on standing (still), and cells between sonars whose readings
-- differ (spread). Figures are means over rooms with 95 % intervals, and differences in pairs.
--
--   ./meander examples/map_experiments.lua --seeds 20 --preset real
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"
local map_trials = require "meander.map_trials"

local options = require "meander.arguments" {
  about = "repeats the experiments of [CN] on maps of sonar readings",
  { "--seeds N", default = 12, least = 1, help = "rooms per preset" },
  { "--first-seed S", default = 2000, least = 0, help = "their seeds begin here; nothing was trained or tuned on 1000 and more" },
  { "--preset NAMES", default = "ideal,real", help = "sonar presets, with commas" },
  { "--model NAMES", default = "all", help = "sensor models, with commas, or all" },
  { "--experiment NAMES", default = "all", help = table.concat(map_trials.experiments, ", ") .. ", or all" },
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

local models = candidates.chosen(options.model, meander.mapping.models(), "model")
local presets = candidates.chosen(options.preset, { "ideal", "real" }, "preset")
local experiments = candidates.chosen(options.experiment, map_trials.experiments, "experiment")

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
local setting = {
  models = models, wanted = wanted, places = options.places, drive = options.drive, thresholds = thresholds,
}

local figure_names = {
  direction = { "error_cm", "missed", "phantom" },
  robustness = { "flipped", "ce", "brier", "auc" },
  adaptability = { "scans_to_half", "scans_to_clear", "first_update" },
  rotation = { "flipped" },
  fused = { "ce", "brier", "auc", "ece", "error_cm" },
  still = { "ce_1", "ce_10", "ce_60", "limited_1", "limited_10", "limited_60" },
  spread = { "more", "alike", "apart" },
}

local by_both_rules = { direction = true, fused = true, still = true }

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
  local line = { experiment = experiment, preset = preset, model = model, fusion = fusion, n = #trials }
  local keys = { "experiment", "preset", "model", "fusion", "n" }
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
      if line[name .. "_n"] < line.n then text = text .. " in " .. line[name .. "_n"] .. " of " .. line.n end
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
    return map_trials.trial(setting, preset, seed)
  end }) do
    if not result.ok then report.failure(("%s, seed %d: %s"):format(preset, result.seed, result.error)) end
    trials[#trials + 1] = result.value
  end
  for _, experiment in ipairs(experiments) do
    local rules = by_both_rules[experiment] and { "viewbin", "bayes" } or { "viewbin" }
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

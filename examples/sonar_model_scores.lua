-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What single scans tell: how well the sensor models know occupied from free cells in rooms that no network has learnt in.
-- Each room is one sample; all models see the same scans, so that differences are paired.
--
--   ./meander examples/sonar_model_scores.lua --rooms 20
local json = require "meander.json"
local candidates = require "meander.candidates"
local report = require "meander.report"
local rooms = require "meander.sonar_rooms"

local options = require "meander.arguments" {
  about = "measures sensor models on single scans",
  { "--model NAMES", default = "all", help = "one or several with commas, or all" },
  { "--sonar NAMES", default = "ideal,real", help = "ideal, real, or both with a comma" },
  { "--against NAME", default = "nn4", values = meander.mapping.models(), help = "model that the others are compared with" },
  { "--rooms N", default = 20, least = 1, help = "rooms, each with a seed of its own" },
  { "--poses N", default = 30, least = 1, help = "places in each" },
  { "--seed N", default = 2001, least = 0, help = "seed of the first room" },
  { "--json", help = "one JSON object per model and sonar instead of text" },
  { "--out DIR", default = "", help = "folder for the figures as JSON lines; none when empty" },
}

local models = candidates.chosen(options.model, meander.mapping.models(), "model")

-- Figures of one model in each room: lists of cross-entropies, and means of the rest.
local function measured(name, table, sonar, lessons)
  local model = meander.mapping.model(name, { preset = sonar, table = table })
  local ce, brier, auc = {}, {}, {}
  for i, lesson in ipairs(lessons) do
    local score = model:score(lesson)
    ce[i], brier[i], auc[i] = score.ce, score.brier, score.auc
  end
  return { ce = ce, brier = meander.study.mean(brier), auc = meander.study.mean(auc) }
end

local keys = { "experiment", "preset", "model", "n", "ce", "ce_low", "ce_high", "brier", "auc", "more", "more_low", "more_high", "table_ce" }
local lines = {}
for _, sonar in ipairs(candidates.chosen(options.sonar, { "ideal", "real" }, "sonar")) do
  local lessons = {}
  for i = 1, options.rooms do
    local seed = options.seed + i - 1
    lessons[i] = meander.mapping.lessons { worlds = { rooms.make(seed).world }, sonar = sonar, poses = options.poses, seed = seed }
  end
  local reference = measured(options.against, false, sonar, lessons)
  for _, name in ipairs(models) do
    local figures = measured(name, false, sonar, lessons)
    local ce, low, high = meander.study.bootstrap_mean(figures.ce)
    local more, more_low, more_high = meander.study.compare(figures.ce, reference.ce)
    local as_table = name:find "^nn" and meander.study.mean(measured(name, true, sonar, lessons).ce) or nil
    lines[#lines + 1] = json.encode({ experiment = "scan", preset = sonar, model = name, n = options.rooms, ce = ce, ce_low = low,
      ce_high = high, brier = figures.brier, auc = figures.auc, more = more, more_low = more_low, more_high = more_high,
      table_ce = as_table }, keys)
    if options.json then
      print(lines[#lines])
    else
      print(("%-5s %-5s  CE %.3f (%.3f to %.3f)  Brier %.3f  AUC %.3f  against %s %+.3f (%+.3f to %+.3f)%s"):format(
        sonar, name, ce, low, high, figures.brier, figures.auc, options.against, more, more_low, more_high,
        as_table and ("  as a table %.3f"):format(as_table) or ""))
    end
  end
end

if options.out ~= "" then
  local file <close> = assert(io.open(report.path(options, "sonar_model_scores.jsonl"), "w"))
  file:write(table.concat(lines, "\n"), "\n")
end

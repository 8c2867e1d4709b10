-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- ALICE explores, then drives over the links of its map to places chosen by chance. Every drive starts anew from a moment
-- of the exploration's end, so that one lost robot costs one drive. Success: it believes to have arrived and is within
-- 0.5 m of where the place truly is; a false arrival: it believes so and is not.
--
--   ./meander examples/alice_navigate.lua --world all --seeds 20
local alice = require "meander.alice"
local candidates = require "meander.candidates"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "drives over the links of a topologic map",
  { "--world NAMES", default = "alice_loop", help = "alice_loop, alice_rooms, alice_grid, with commas, or all" },
  { "--samples N", default = 5000, least = 100, most = 1000000, help = "explored before" },
  { "--goals N", default = 20, least = 1, most = 1000, help = "drives per seed" },
  { "--seeds N", default = 1, least = 1, most = 100000, help = "runs" },
  { "--first-seed S", default = 2000, least = 0, help = "their seeds begin here; 1 to 999 are for tuning" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--json", help = "one JSON object per line instead of text" },
  { "--out DIR", default = "out", help = "folder for the picture of the first drive; none when empty" },
}

local function trial(name, seed)
  local moments = {}
  local robot = alice.explore {
    world = name, seed = seed, samples = options.samples,
    each = function(sample, now) alice.keep_moment(moments, options, sample, now) end,
  }
  local success, false_arrivals, reasons = 0, 0, {}
  for k, moment in ipairs(moments) do
    local start = { sim = moment.sim, map = moment.map, scores = robot.scores }
    local arrived, wrongly, reason, run = alice.go(start, alice.goal(start))
    success = success + (arrived and 1 or 0)
    false_arrivals = false_arrivals + (wrongly and 1 or 0)
    if not arrived then reasons[#reasons + 1] = wrongly and "wrong place" or reason end
    if k == 1 and options.out ~= "" and seed == options.first_seed then
      run:save(report.path(options, name .. "_route.svg"))
    end
  end
  return { success = success / #moments, false_arrivals = false_arrivals / #moments, goals = #moments, reasons = reasons }
end

for _, name in ipairs(candidates.chosen(options.world, alice.worlds, "world")) do
  local trials = alice.trials(options, function(seed) return trial(name, seed) end)
  local goals, reasons = 0, {}
  for _, one in ipairs(trials) do
    goals = goals + one.goals
    for _, reason in ipairs(one.reasons) do reasons[reason] = (reasons[reason] or 0) + 1 end
  end
  alice.print(options, { { "world", name }, { "n", #trials }, { "goals", goals } }, trials, { "success", "false_arrivals" })
  if not options.json then
    local list = {}
    for reason, count in pairs(reasons) do list[#list + 1] = ("  %d times: %s"):format(count, reason) end
    table.sort(list)
    for _, text in ipairs(list) do print(text) end
  end
end

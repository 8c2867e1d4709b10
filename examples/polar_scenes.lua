-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Drives navigators through the scenes on which local navigation is measured, each over many seeds, and tells how often
-- they reach the goal, what they touch, how long it takes, with 95 % intervals.
--
--   ./meander examples/polar_scenes.lua --scene u_trap --navigator potential_field --seeds 20
--   ./meander examples/polar_scenes.lua --navigator vfh_plus --options "speed_gap = 0.4" --sonar real --drift 0.05
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"
local scenes = require "meander.scenes"

local options = require "meander.arguments" {
  about = "measures navigators on the scenes of local navigation",
  { "--scene NAMES", default = "all", help = "one or several with commas, or all" },
  { "--navigator NAMES", default = "polar", help = "one or several with commas, or all" },
  { "--options TEXT", default = "", help = "options of the navigator, as in a Lua table" },
  { "--seeds N", default = 20, help = "trials per scene; seeds without a feasible scene are passed over" },
  { "--first-seed S", default = 2000, help = "their seeds begin here; the navigators were tuned on 1 to 1000" },
  { "--sonar NAME", default = "nomad", help = "ideal, nomad or real" },
  { "--drift SHARE", default = 0.0, help = "odometry tells ways and turns wrong by so much, either way" },
  { "--jitter SHARE", default = 0.0, help = "standard deviation of the control period" },
  { "--list", help = "tells the names of the scenes" },
  { "--json", help = "one JSON object per scene and navigator instead of text" },
  { "--jobs N", default = 0, help = "worker processes; 0: one per core" },
  { "--out DIR", default = "", help = "folder for pictures of the first run of each scene; none when empty" },
}

local chosen, column, sum, median = candidates.chosen, candidates.column, candidates.sum, candidates.median

local keys = {
  "scene", "navigator", "n", "reached", "contacts", "fault_contacts", "trapped", "time_median", "length_median",
  "cycle_us_median",
}

local navigator_of = candidates.maker(options.options)

local function drive(name, navigator, seed)
  local scene, why = scenes.make(name, seed)
  if not scene then return { passed_over = why } end
  local sign = (seed % 2 == 0) and 1 or -1
  local sim = meander.sim.new {
    world = scene.world, start = scene.start, robot = "nomad200", sonar = options.sonar, seed = seed,
    period_jitter = options.jitter,
    drift = { distance_bias = sign * options.drift, turn_bias = (seed % 4 < 2 and 1 or -1) * options.drift },
  }
  local run = sim:drive {
    navigator = navigator_of(navigator, "nomad200"), subgoals = scene.subgoals, hand_over = scene.hand_over,
    when_trapped = "insist", time_limit = scene.time_limit, record_every = options.out == "" and 0 or 1,
  }
  if options.out ~= "" then run:save(report.path(options, ("%s_%s_%d.svg"):format(name, navigator, seed))) end
  return {
    success = run.success, contacts = run.contacts, fault_contacts = run.fault_contacts, trapped = run.trapped,
    time = run.time, length = run.length, clearance = run.clearance_min, cycle_us = 1e6 * run.cpu_per_cycle,
  }
end

-- Runs of `count` seeds that have a scene; at most ten times as many are looked at.
local function trials(name, navigator, count)
  local runs, seed = {}, options.first_seed
  local last = seed + 10 * count
  while #runs < count and seed < last do
    local seeds = {}
    for i = 1, count - #runs do seeds[i], seed = seed, seed + 1 end
    for _, result in ipairs(meander.study.trials { seeds = seeds, jobs = options.jobs, trial = function(s)
      return drive(name, navigator, s)
    end }) do
      if not result.ok then error(("%s, %s, seed %d: %s"):format(name, navigator, result.seed, result.error), 0) end
      if not result.value.passed_over then runs[#runs + 1] = result.value end
    end
  end
  return runs, seed - options.first_seed
end

local function say(name, navigator, runs, looked_at)
  local arrived = function(run) return run.success end
  local reached, count = #column(runs, "time", arrived), #runs
  local share, low, high = 0 / 0, 0 / 0, 0 / 0
  if count > 0 then share, low, high = meander.study.wilson(reached, count) end
  local trapped = #column(runs, "time", function(run) return run.trapped > 0 end)
  local contacts, faults = math.tointeger(sum(column(runs, "contacts"))), math.tointeger(sum(column(runs, "fault_contacts")))
  local time, time_low, time_high = median(column(runs, "time", arrived))
  local length, length_low, length_high = median(column(runs, "length", arrived))
  local cycle = median(column(runs, "cycle_us"))
  if options.json then
    print(json.encode({
      scene = name, navigator = navigator, n = count, reached = reached, contacts = contacts, fault_contacts = faults,
      trapped = trapped, time_median = candidates.rounded(time, 3), length_median = candidates.rounded(length, 3),
      cycle_us_median = candidates.rounded(cycle, 2),
    }, keys))
    return
  end
  print(("%s, %s: %s"):format(name, navigator, scenes.text(name)))
  if count < looked_at then print(("  %d of %d seeds have such a scene"):format(count, looked_at)) end
  if count == 0 then return end
  print(("  reached   %d of %d: %.0f %% (%.0f to %.0f %%)"):format(reached, count, 100 * share, 100 * low, 100 * high))
  print(("  contacts  %d, of these %d the robot's own fault; least clearance, median %.3f m"):format(
    contacts, faults, median(column(runs, "clearance"))))
  print(("  trapped   reported in %d runs, %d times"):format(trapped, sum(column(runs, "trapped"))))
  if reached > 0 then
    print(("  time      %.1f s (%.1f to %.1f), way %.2f m (%.2f to %.2f)"):format(
      time, time_low, time_high, length, length_low, length_high))
  end
  print(("  cycle     %.1f us of navigator and guide"):format(cycle))
end

if options.list then
  for _, name in ipairs(scenes.names()) do print(("%-18s %s"):format(name, scenes.text(name))) end
  os.exit(0, true)
end
if options.seeds < 1 then report.usage_error("--seeds: at least 1 expected, got " .. options.seeds) end
if options.first_seed < 0 then report.usage_error("--first-seed: at least 0 expected, got " .. options.first_seed) end
chosen(options.sonar, { "ideal", "nomad", "real" }, "sonar")
for _, navigator in ipairs(chosen(options.navigator, meander.autonomy.navigators(), "navigator")) do
  for _, name in ipairs(chosen(options.scene, scenes.names(), "scene")) do
    say(name, navigator, trials(name, navigator, options.seeds))
  end
end

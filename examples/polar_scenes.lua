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
local trials = require "meander.scene_trials"

local options = require "meander.arguments" {
  about = "measures navigators on the scenes of local navigation",
  { "--scene NAMES", default = "all", help = "one or several with commas, or all" },
  { "--navigator NAMES", default = "polar", help = "one or several with commas, or all" },
  { "--options TEXT", default = "", help = "options of the navigator, as in a Lua table" },
  { "--seeds N", default = 20, least = 1, most = 1000000, help = "trials per scene; seeds without a feasible scene are passed over" },
  {
    "--first-seed S", default = 2000, least = 0, most = 1000000000,
    help = "their seeds begin here; the navigators were tuned on 1 to 1000",
  },
  { "--sonar NAME", default = "nomad", values = trials.sonars, help = "crosstalk is real, in pairs that hear each other" },
  { "--drift SHARE", default = 0.0, least = 0, most = 0.9, help = "odometry tells ways wrong by so much, either way" },
  { "--turn-drift SHARE", default = 0.0, least = 0, most = 0.9, help = "and turns" },
  { "--jitter SHARE", default = 0.0, least = 0, most = 1, help = "standard deviation of the control period" },
  { "--delay CYCLES", default = 0, least = 0, most = 1000, help = "commands take effect so much later" },
  { "--time-limit S", default = 0.0, least = 0, most = 100000, help = "simulated seconds; 0: the scene's own limit" },
  { "--list", help = "tells the names of the scenes" },
  { "--json", help = "one JSON object per scene and navigator instead of text" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--out DIR", default = "", help = "folder for pictures of the runs; none when empty" },
}

local chosen, column, sum, median = candidates.chosen, candidates.column, candidates.sum, candidates.median

local keys = {
  "scene", "navigator", "n", "reached", "contacts", "fault_contacts", "trapped", "time_median", "length_median",
  "cycle_us_median", "pictures",
}

local navigators = chosen(options.navigator, meander.autonomy.navigators(), "navigator")
local navigator_of = candidates.maker(options.options, navigators, "nomad200")

local function trials_of(name, navigator)
  local which = { count = options.seeds, first_seed = options.first_seed, jobs = options.jobs }
  if options.out ~= "" then
    which.out = function(seed) return report.path(options, ("%s_%s_%d.svg"):format(name, navigator, seed)) end
  end
  return trials.over(name, function() return navigator_of(navigator, "nomad200") end, which, {
    sonar = options.sonar, drift = options.drift, turn_drift = options.turn_drift, jitter = options.jitter,
    delay = options.delay, time_limit = options.time_limit > 0 and options.time_limit or nil,
  })
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
  local cycle, pictures = median(column(runs, "cycle_us")), column(runs, "picture")
  if options.json then
    print(json.encode({
      scene = name, navigator = navigator, n = count, reached = reached, contacts = contacts, fault_contacts = faults,
      trapped = trapped, time_median = candidates.rounded(time, 3), length_median = candidates.rounded(length, 3),
      cycle_us_median = candidates.rounded(cycle, 2), pictures = pictures[1] and pictures,
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
  if #pictures > 0 then print(("  pictures  %d: %s to %s"):format(#pictures, pictures[1], pictures[#pictures])) end
end

if options.list then
  for _, name in ipairs(scenes.names()) do print(("%-18s %s"):format(name, scenes.text(name))) end
  os.exit(0, true)
end
for _, navigator in ipairs(navigators) do
  for _, name in ipairs(chosen(options.scene, scenes.names(), "scene")) do
    say(name, navigator, trials_of(name, navigator))
  end
end

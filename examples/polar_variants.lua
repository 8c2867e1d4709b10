-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What disturbances cost the polar navigator, and what each of its parts is worth: drives the same seeds of the same
-- scenes twice, as it is and changed, and compares the pairs.
--
--   ./meander examples/polar_variants.lua --variant drift,crosstalk,jitter,disturbed --seeds 100
--   ./meander examples/polar_variants.lua --variant no_prediction --scene four_targets
local candidates = require "meander.candidates"
local json = require "meander.json"
local report = require "meander.report"
local scenes = require "meander.scenes"
local trials = require "meander.scene_trials"

local usual = "four_targets,u_trap,office,clutter_10,doors"

-- Settings of meander.scene_trials and options of the navigator: of both ways (`both`), and of the changed one alone.
local list = {
  { "drift", usual, "odometry tells ways 5 % wrong", { drift = 0.05 } },
  { "turn_drift", usual, "odometry tells ways and turns 5 % wrong", { drift = 0.05, turn_drift = 0.05 } },
  { "crosstalk", usual, "sonars as recorded ones, fired in pairs that hear each other", { sonar = "crosstalk" } },
  { "jitter", usual, "control periods with a standard deviation of 20 %", { jitter = 0.2 } },
  { "disturbed", usual, "drift of ways, crosstalk and jitter", { drift = 0.05, sonar = "crosstalk", jitter = 0.2 } },
  {
    "no_prediction", "four_targets,u_trap", "without prediction, commands a cycle late",
    { options = { prediction = { enabled = false } } }, both = { delay = 1 },
  },
  {
    "memory_1", "u_trap,four_targets,clutter_10", "one scan remembered instead of ten, both without escapes",
    { options = { memory = { scans = 1 } } }, both = { options = { trap = { watch = false } } },
  },
  { "no_hand_over", "office", "every subgoal is reached before the next is given", { hand_over = 0 } },
  { "paper", "all", "without all remedies beyond the paper", { options = { mode = "paper" } } },
  {
    "no_hysteresis", usual .. ",clutter_10_tight", "the most active direction wins at once",
    { options = { subgoal = { hysteresis = 0 } } },
  },
  {
    "hysteresis_10", usual .. ",clutter_10_tight", "another direction wins when its way is 0.1 m shorter",
    { options = { subgoal = { hysteresis = 0.1 } } },
  },
  {
    "no_contradictions", usual .. ",clutter_10_tight", "contradicted points are kept",
    { options = { memory = { contradictions = 0 } } },
  },
  {
    "no_escape", "clutter_10,clutter_10_tight,clutter_20,large_u", "traps are not watched for",
    { options = { trap = { watch = false } } },
  },
  {
    "forbidding", usual .. ",people", "the slow zone costs at any speed, as in the paper's mode",
    { options = { control = { soft_margin = 0.20, soft_samples = 0.8, soft_speed_cost = 0 } } },
  },
  { "sectors_32", usual .. ",clutter_10_tight", "32 sectors instead of 48", { options = { map = { sectors = 32 } } } },
  {
    "log_32", usual, "32 x 32 units with logarithmic radii",
    { options = { map = { rings = 32, sectors = 32, radii = "log" } } },
  },
  {
    "euclidean", "four_targets,l_corner,doors,clutter_10", "the paper's weights 1 / distance",
    { options = { map = { weights = "euclidean" } } },
  },
  {
    "literal", "four_targets,l_corner,doors,clutter_10", "the same, the direction read off at the innermost ring",
    { options = { map = { weights = "euclidean" }, subgoal = { read_radius = 0 } } },
  },
}

local names = {}
for i, entry in ipairs(list) do names[i] = entry[1] end

local options = require "meander.arguments" {
  about = "compares the polar navigator with itself under disturbances and without its parts",
  { "--variant NAMES", default = "all", help = "one or several with commas, or all" },
  { "--scene NAMES", default = "", help = "one or several with commas, or all; the variant's own when empty" },
  { "--seeds N", default = 20, least = 1, most = 1000000, help = "pairs of runs per scene" },
  {
    "--first-seed S", default = 2000, least = 0, most = 1000000000,
    help = "their seeds begin here; the navigators were tuned on 1 to 1000",
  },
  { "--list", help = "tells the names of the variants" },
  { "--json", help = "one JSON object per variant and scene instead of text" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--out DIR", default = "", help = "not used: there are no pictures" },
}

local function count(runs, key)
  local total = 0
  for _, run in ipairs(runs) do
    local value = run[key]
    total = total + (value == true and 1 or tonumber(value) or 0)
  end
  return math.tointeger(total)
end

-- Seconds that the change costs in the pairs in which both arrive: median before and after, mean difference, interval.
local function time_cost(before, after)
  local a, b = {}, {}
  for i, run in ipairs(before) do
    if run.success and after[i].success then a[#a + 1], b[#b + 1] = run.time, after[i].time end
  end
  if #a == 0 then return 0 / 0, 0 / 0, 0 / 0, 0 / 0, 0 / 0 end
  local mean, low, high = meander.study.compare(b, a)
  return (meander.study.median(a)), (meander.study.median(b)), mean, low, high
end

local keys = {
  "variant", "scene", "n", "reached", "reached_changed", "fault_contacts", "fault_contacts_changed", "time_median",
  "time_median_changed", "time_difference", "time_difference_low", "time_difference_high",
}

local function say(variant, scene, before, after)
  local a, b, mean, low, high = time_cost(before, after)
  local line = {
    variant = variant, scene = scene, n = #before, reached = count(before, "success"),
    reached_changed = count(after, "success"), fault_contacts = count(before, "fault_contacts"),
    fault_contacts_changed = count(after, "fault_contacts"), time_median = candidates.rounded(a, 2),
    time_median_changed = candidates.rounded(b, 2), time_difference = candidates.rounded(mean, 2),
    time_difference_low = candidates.rounded(low, 2), time_difference_high = candidates.rounded(high, 2),
  }
  if options.json then return print(json.encode(line, keys)) end
  local time = a == a and ("time %6.1f -> %6.1f s, %+.1f s (%+.1f to %+.1f)"):format(a, b, mean, low, high)
    or "no pair in which both arrive"
  print(("  %-17s reached %3d -> %3d of %d, own contacts %d -> %d, %s"):format(
    scene, line.reached, line.reached_changed, line.n, line.fault_contacts, line.fault_contacts_changed, time))
end

-- The runs of one way: a setting with the navigator's options in it.
local function runs_of(scene, setting)
  local function navigator()
    local own = { robot = "nomad200" }
    for key, value in pairs(setting.options or {}) do own[key] = value end
    return meander.polar.navigator(own)
  end
  local which = { count = options.seeds, first_seed = options.first_seed, jobs = options.jobs }
  return (trials.over(scene, navigator, which, setting))
end

-- One setting over the other, their options of the navigator joined.
local function joined(under, over)
  local result = { options = {} }
  for _, setting in ipairs { under, over } do
    for key, value in pairs(setting) do
      if key ~= "options" then result[key] = value end
    end
    for key, value in pairs(setting.options or {}) do result.options[key] = value end
  end
  return result
end

if options.list then
  for _, entry in ipairs(list) do print(("%-18s %s"):format(entry[1], entry[3])) end
  os.exit(0, true)
end
local wanted = {}
for _, name in ipairs(candidates.chosen(options.variant, names, "variant")) do wanted[name] = true end
local standard = {} -- runs of the navigator as it is, by scene
for _, entry in ipairs(list) do
  if wanted[entry[1]] then
    if not options.json then print(entry[1] .. ": " .. entry[3]) end
    local where = options.scene == "" and entry[2] or options.scene
    for _, scene in ipairs(candidates.chosen(where, scenes.names(), "scene")) do
      local before = not entry.both and standard[scene] or runs_of(scene, entry.both or {})
      if not entry.both then standard[scene] = before end
      say(entry[1], scene, before, runs_of(scene, joined(entry.both or {}, entry[4])))
    end
  end
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Tunes the options of a navigator on the scenes of local navigation: in each round the best so far and some mutants of it
-- drive the same fresh seeds, and the best of them goes on. Seeds from 1 to 1000 are for this; what it finds is to be
-- measured on others with polar_scenes.lua. poles_16 and poles_32 are fields of poles in the manner of the BARN benchmark,
-- driven by its robot with so many sonars; all means the other scenes.
--
--   ./meander examples/tune_navigator.lua --navigator vfh_plus --rounds 40
local json = require "meander.json"
local candidates = require "meander.candidates"
local fields = require "meander.pole_fields"
local scenes = require "meander.scenes"

local options = require "meander.arguments" {
  about = "tunes the options of a navigator",
  { "--navigator NAME", default = "vfh_plus", help = "vfh_plus, dynamic_window, tangent_bug or potential_field" },
  { "--scene NAMES", default = "all", help = "one or several with commas, or all" },
  { "--rounds N", default = 20, least = 1, most = 1000000, help = "rounds of the search" },
  { "--mutants N", default = 5, least = 1, most = 1000, help = "tried per round" },
  { "--seeds N", default = 3, least = 1, most = 500, help = "trials per scene and round" },
  { "--seed N", default = 7, least = 0, most = 1000000000, help = "seed of the search" },
  { "--json", help = "one JSON object per round instead of text" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
}

-- What is tuned: the default, and the least and largest value. A name with a dot is an option in a table of options.
local function steering(turn_gain, margin, headway, caution)
  return {
    { "steering.turn_gain", turn_gain, 0.3, 4 }, { "steering.margin", margin, 0.005, 0.15 },
    { "steering.headway", headway, 0.01, 0.6 }, { "steering.caution", caution, 0.02, 0.6 },
  }
end
local function memory(scans, contradictions)
  return { { "memory.scans", scans, 1, 60, whole = true }, { "memory.contradictions", contradictions, 0, 4, whole = true } }
end
local spaces = {
  vfh_plus = {
    { "window", 1, 0.6, 4 }, { "enlarge", 0.02, 0.005, 0.3 }, { "low", 0.45, 0.05, 6 }, { "high", 1, 0.1, 12 },
    { "wide_valley", 11, 3, 30, whole = true }, { "heading_weight", 2.3, 0.1, 10 }, { "previous_weight", 2.6, 0.1, 10 },
    { "half_cone", 0.1, 0, 0.218 }, steering(2.3, 0.10, 0.15, 0.33), memory(6, 4),
  },
  dynamic_window = {
    { "heading_weight", 3, 0.2, 10 }, { "distance_weight", 0.2, 0.02, 5 }, { "speed_weight", 0.32, 0.02, 5 },
    { "margin", 0.07, 0.01, 0.2 }, { "reach", 3.4, 0.5, 4 },
    { "half_cone", 0.218, 0, 0.218 }, memory(12, 2),
  },
  tangent_bug = {
    { "reach", 1.9, 0.8, 4 }, { "clearance", 0.06, 0.01, 0.25 }, { "jump", 0.17, 0.05, 1 }, { "constancy", 0.53, 0.01, 1 },
    { "follow_look", 0.87, 0.2, 1.5 }, { "leave", 0.16, 0.02, 0.6 },
    { "half_cone", 0, 0, 0.218 }, steering(1.1, 0.09, 0.42, 0.08), memory(17, 1),
  },
  potential_field = {
    { "influence", 0.43, 0.1, 1.5 }, { "repulsion", 0.0025, 0.0002, 0.1 }, { "turn_gain", 0.63, 0.2, 3 },
    { "margin", 0.02, 0.005, 0.1 }, { "headway", 0.1, 0.01, 0.6 }, { "caution", 0.15, 0.02, 0.6 },
  },
}

local poles = { poles_16 = fields.robot(16, 2), poles_32 = fields.robot(32, 2) }
local known = table.move({ "poles_16", "poles_32" }, 1, 2, #scenes.names() + 1, scenes.names())
local names = options.scene == "all" and scenes.names() or candidates.chosen(options.scene, known, "scene")
candidates.chosen(options.navigator, { "dynamic_window", "potential_field", "tangent_bug", "vfh_plus" }, "navigator")

local space = {}
for _, entry in ipairs(spaces[options.navigator]) do
  if type(entry[1]) == "table" then
    table.move(entry, 1, #entry, #space + 1, space)
  else
    space[#space + 1] = entry
  end
end

-- The options of a point, nested where a name has a dot.
local function table_of(point, robot)
  local result = { robot = robot }
  for i, entry in ipairs(space) do
    local outer, inner = entry[1]:match "^(.-)%.(.*)$"
    if outer then
      result[outer] = result[outer] or {}
      result[outer][inner] = point[i]
    else
      result[entry[1]] = point[i]
    end
  end
  if result.low and result.low > result.high then result.low = result.high end
  if result.half_cone and type(robot) == "table" then
    result.half_cone = math.min(result.half_cone, math.pi / robot.sonar.count)
  end
  return result
end

local function text_of(point)
  local words = {}
  for i, entry in ipairs(space) do words[i] = ("%s = %.4g"):format(entry[1], point[i]) end
  return table.concat(words, ", ")
end

math.randomseed(options.seed)
local function normal() return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random()) end

-- One to three of the values, each about a third larger or smaller.
local function mutant(point)
  local copy = table.move(point, 1, #point, 1, {})
  for _ = 1, math.random(3) do
    local i = math.random(#space)
    local entry = space[i]
    local value = (copy[i] + (entry.whole and math.random(0, 1) or 0)) * math.exp(0.35 * normal())
    if entry.whole then value = math.floor(value + 0.5) end
    copy[i] = math.max(entry[3], math.min(entry[4], value))
    if entry.whole then copy[i] = math.tointeger(copy[i]) end
  end
  return copy
end

-- 1 for a quick arrival, down to 0.7 for one at the last moment, 0 for none; a contact of its own fault costs half a run.
-- In a field of poles twice the benchmark's metric is the score.
local function score_of(point, name, seed)
  local make = meander.polar[options.navigator]
  if poles[name] then
    local world, length = fields.make(seed)
    local navigator = make(table_of(point, poles[name]))
    local result = fields.drive { world = world, length = length, navigator = navigator, robot = poles[name], seed = seed }
    return 2 * result.metric - (result.collided and 0.5 or 0)
  end
  local scene = scenes.make(name, seed)
  if not scene then return nil end
  local sim = meander.sim.new { world = scene.world, start = scene.start, seed = seed }
  local run = sim:drive {
    navigator = make(table_of(point, "nomad200")), subgoals = scene.subgoals, hand_over = scene.hand_over,
    when_trapped = "insist", time_limit = scene.time_limit, record_every = 0,
  }
  local reached = run.success and 1 - 0.3 * run.time / scene.time_limit or 0
  return reached - 0.5 * math.min(1, run.fault_contacts)
end

-- Mean scores of the points over all scenes and these seeds.
local function scores(points, first_seed)
  local jobs, numbers = {}, {}
  for p = 1, #points do
    for _, name in ipairs(names) do
      for s = 0, options.seeds - 1 do
        jobs[#jobs + 1] = { p, name, first_seed + s }
        numbers[#numbers + 1] = #jobs
      end
    end
  end
  local sums, counts = {}, {}
  for i, result in ipairs(meander.study.trials { seeds = numbers, jobs = options.jobs, trial = function(number)
    local job = jobs[number]
    return { score = score_of(points[job[1]], job[2], job[3]) }
  end }) do
    if not result.ok then error(result.error, 0) end
    local p, score = jobs[i][1], result.value.score
    if score then sums[p], counts[p] = (sums[p] or 0) + score, (counts[p] or 0) + 1 end
  end
  local means = {}
  for p = 1, #points do means[p] = (sums[p] or 0) / (counts[p] or 1) end
  return means
end

local best = {}
for i, entry in ipairs(space) do best[i] = entry[2] end
for round = 1, options.rounds do
  local points = { best }
  for i = 1, options.mutants do points[i + 1] = mutant(best) end
  local means = scores(points, 1 + (round - 1) * options.seeds % (1000 - options.seeds))
  local winner = 1
  for p = 2, #points do
    if means[p] > means[winner] then winner = p end
  end
  best = points[winner]
  if options.json then
    print(json.encode({ navigator = options.navigator, round = round, score = candidates.rounded(means[winner], 4),
      before = candidates.rounded(means[1], 4), options = text_of(best) },
      { "navigator", "round", "score", "before", "options" }))
  else
    print(("round %d: score %.3f, before %.3f: %s"):format(round, means[winner], means[1], text_of(best)))
  end
end

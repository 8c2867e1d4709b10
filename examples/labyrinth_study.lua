-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Explorers in many labyrinths: do they reach the goal, how long is the way in the first runs, when is the shortest route
-- proven? With --sensor graph the robot recognises every crossing: what the rules are worth, apart from what sonars hear.
-- With --sensor sonar a robot drives by what its sonars tell; nomad and real: sonars that do not hear walls seen aslant.
--
--   ./meander examples/labyrinth_study.lua --kind mixed --size 20 --loops 0.05 --seeds 100
--   ./meander examples/labyrinth_study.lua --size 10 --rules literal --seeds 100
--   ./meander examples/labyrinth_study.lua --size 20 --explorer tremaux --seeds 100
--   ./meander examples/labyrinth_study.lua --size 20 --loops 0.1 --goal walled --seeds 100
--   ./meander examples/labyrinth_study.lua --sensor sonar --loops 0.08 --seeds 40 --runs 3
--   ./meander examples/labyrinth_study.lua --sensor sonar --loops 0.08 --seeds 40 --runs 3 --explorer frontier
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "lets explorers explore labyrinths",
  { "--kind NAME", default = "mixed", values = { "backtracker", "prim", "mixed" }, help = "how the labyrinth grows" },
  { "--size N", default = 10, help = "cells along each side" },
  { "--loops P", default = 0.0, help = "share of inner walls that are taken away" },
  { "--seeds N", default = 20, help = "labyrinths" },
  { "--first-seed N", default = 2001, help = "seed of the first one" },
  { "--sensor NAME", default = "graph", values = { "graph", "sonar", "nomad", "real" }, help = "what the robot perceives by" },
  { "--rules NAME", default = "optimistic", values = { "literal", "repaired", "optimistic" }, help = "how the explorer reads the paper" },
  { "--explorer NAME", default = "indicator", values = { "indicator", "tremaux", "depth_first", "nearest", "random_walk", "free_space", "frontier", "goal_frontier" }, help = "who decides" },
  { "--eps X", default = 0.0, help = "stop when nothing can shorten the route by more" },
  { "--limit S", default = 4000.0, help = "simulated seconds of a run, with sonars" },
  { "--runs N", default = 60, help = "at most so many runs until the route is proven" },
  { "--goal STATE", default = "open", values = { "open", "walled" }, help = "walled: no way leads to it" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "not used: nothing is drawn" },
}
if options.seeds < 1 then report.usage_error("--seeds: at least 1 expected, got " .. options.seeds) end
if options.size < 2 or options.size > 200 then report.usage_error("--size: 2 to 200 expected, got " .. options.size) end
if options.loops < 0 or options.loops > 1 then report.usage_error("--loops: 0 to 1 expected, got " .. options.loops) end
local on_map = { free_space = true, frontier = true, goal_frontier = true }
if options.sensor == "graph" and on_map[options.explorer] then
  report.usage_error("--explorer " .. options.explorer .. ": needs a map, and that a robot with --sensor sonar")
end
if options.runs < 3 and options.sensor == "graph" then report.usage_error("--runs: at least 3 expected, got " .. options.runs) end

if options.runs < 1 then report.usage_error("--runs: at least 1 expected, got " .. options.runs) end

local learns = options.explorer == "indicator" and options.rules ~= "literal"

-- One labyrinth, from the first run to the proof: a table of numbers.
local function trial(seed)
  local cells = meander.indicator.labyrinth { kind = options.kind, size = options.size, loops = options.loops, seed = seed }
  if options.goal == "walled" then
    for _, side in ipairs { "west", "south" } do cells:set_open(options.size, options.size, side, false) end
  end
  local shortest = cells:shortest()
  local explorer = meander.indicator.explorer {
    goal = cells.goal, explorer = options.explorer, rules = options.rules, eps = options.eps, seed = seed,
  }
  local result = { shortest = shortest or false, failed = false, runs = {}, decisions = 0 }
  local began = os.clock()
  local last
  for run = 1, options.runs do
    last = cells:explore(explorer)
    result.runs[run] = last.length
    result.decisions = result.decisions + last.decisions
    local arrived = last.last.x == cells.goal.x and last.last.y == cells.goal.y
    result.false_arrival = result.false_arrival or (last.ending == "reached" and not arrived)
    if last.ending ~= "reached" then
      result.failed = true
      break
    end
    if not result.proof and explorer.state.proven then result.proof = run end
    if run >= 3 and (result.proof or not learns) then break end
  end
  result.us = (os.clock() - began) * 1e6 / result.decisions
  result.ending, result.coverage = last.ending, last.coverage
  local _, length = explorer:route()
  result.optimal = shortest ~= nil and length ~= nil and math.abs(length - shortest) < 1e-6
  result.indicators, result.corridors = #explorer:graph(), 0
  for _, link in ipairs(explorer:graph().links) do result.corridors = result.corridors + link.length end
  return result
end

-- The same by sonar: what the robot drove, and where it truly is in the end.
local function drive(seed)
  local course = require "meander.labyrinth_course"
  local cells = meander.indicator.labyrinth { kind = options.kind, size = options.size, loops = options.loops, seed = seed }
  if options.goal == "walled" then
    for _, side in ipairs { "west", "south" } do cells:set_open(options.size, options.size, side, false) end
  end
  local world, shortest = cells:world(), cells:shortest()
  local map_strategy = on_map[options.explorer]
  local explorer = meander.indicator.sonar_explorer(course.explorer {
    goal = cells.goal, sensor = options.sensor, rules = options.rules, eps = options.eps, seed = seed,
    strategy = map_strategy and options.explorer or "indicators", explorer = map_strategy and "indicator" or options.explorer,
  })
  local result = { shortest = shortest or false, failed = false, runs = {}, contacts = 0, blocked = 0, looks = 0 }
  local began, last = os.clock()
  for run = 1, math.min(options.runs, 3) do
    local sim
    last, sim = course.run { world = world, explorer = explorer, seed = 10 * seed + run, sensor = options.sensor, limit = options.limit }
    local pose = sim.robots[1].pose
    local off = math.sqrt((pose.x - cells.goal.x) ^ 2 + (pose.y - cells.goal.y) ^ 2)
    result.runs[run] = explorer.walked
    result.contacts = result.contacts + last.contacts
    result.blocked, result.looks = result.blocked + explorer.blocked, result.looks + explorer.second_looks
    result.ending = explorer.ending
    if explorer.ending == "driving" then result.ending = "time" end
    result.false_arrival = result.false_arrival or (result.ending == "reached" and off > 0.5)
    if result.ending ~= "reached" then
      result.failed = true
      break
    end
    if not result.proof and explorer.proven then result.proof = run end
  end
  result.us = (os.clock() - began) * 1e6 / math.max(explorer.decisions, 1)
  local length = explorer:route()
  result.optimal = shortest ~= nil and length ~= nil and length < 1.05 * shortest
  result.indicators, result.corridors = #explorer:graph(), 0
  for y = 1, options.size do
    for x = 1, options.size do
      for _, side in ipairs { "east", "north" } do
        if cells:open(x, y, side) then result.corridors = result.corridors + 1 end
      end
    end
  end
  return result
end

local seeds = {}
for i = 1, options.seeds do seeds[i] = options.first_seed + i - 1 end
local results = {}
for i, one in ipairs(meander.study.trials { trial = options.sensor == "graph" and trial or drive, seeds = seeds }) do
  if not one.ok then report.failure("seed " .. one.seed .. ": " .. one.error) end
  results[i] = one.value
end

local function count(test)
  local n = 0
  for _, result in ipairs(results) do n = n + (test(result) and 1 or 0) end
  return n
end
-- Mean over the labyrinths for which `value` gives a number; no number: null in JSON.
local function mean(value)
  local list = {}
  for _, result in ipairs(results) do list[#list + 1] = value(result) or nil end
  return #list > 0 and meander.study.mean(list) or 0 / 0
end
local function run_ratio(run)
  return mean(function(r) return r.shortest and not r.failed and r.runs[run] and r.runs[run] / r.shortest end)
end
local function rounded(x) return x == x and tonumber(("%.4f"):format(x)) or x end

local us = {}
for i, result in ipairs(results) do us[i] = result.us end
local line = {
  kind = options.kind, size = options.size, loops = options.loops, sensor = options.sensor, rules = options.rules,
  explorer = options.explorer, n = #results,
  failed = count(function(r) return r.shortest and r.failed end),
  false_unreachable = count(function(r) return r.shortest and r.ending == "no_passable_direction" end),
  false_arrival = count(function(r) return r.false_arrival end),
  r1 = rounded(run_ratio(1)), r2 = rounded(run_ratio(2)), r3 = rounded(run_ratio(3)),
  runs_to_proof = rounded(mean(function(r) return r.proof end)),
  optimal = count(function(r) return r.optimal end) / #results,
  indicators = rounded(mean(function(r) return r.indicators end)),
  decision_us_median = rounded(meander.study.median(us)),
  stated = count(function(r) return not r.shortest and r.ending == "no_passable_direction" end),
  coverage = rounded(mean(function(r) return r.coverage end)),
  walked_over_corridors = rounded(mean(function(r) return not r.shortest and r.runs[1] / r.corridors end)),
}
local keys = {
  "kind", "size", "loops", "sensor", "rules", "explorer", "n", "failed", "false_unreachable", "false_arrival", "r1", "r2",
  "r3", "runs_to_proof", "optimal", "indicators", "decision_us_median",
}
if options.sensor ~= "graph" then
  line.causes = { time = 0, trapped = 0, budget = 0, no_passable_direction = 0 }
  for _, result in ipairs(results) do
    if result.shortest and result.failed then line.causes[result.ending] = line.causes[result.ending] + 1 end
  end
  for _, name in ipairs { "contacts", "blocked", "looks" } do line[name] = rounded(mean(function(r) return r[name] end)) end
  table.move({ "causes", "contacts", "blocked", "looks" }, 1, 4, #keys + 1, keys)
end
if options.goal == "walled" then
  table.move({ "stated", "coverage", "walked_over_corridors" }, 1, 3, #keys + 1, keys)
end
if options.json then
  print(json.encode(line, keys))
  return
end

local name = options.explorer == "indicator" and options.rules .. " rules" or options.explorer
print(("%d %s labyrinths of %d x %d cells, loops %g: %s"):format(line.n, options.kind, options.size, options.size, options.loops, name))
if options.goal == "walled" then
  local share, low, high = meander.study.wilson(line.stated, line.n)
  print(("  unreachable, and stated so in %d of %d (%.1f %%, 95 %% interval %.1f to %.1f)"):format(
    line.stated, line.n, 100 * share, 100 * low, 100 * high))
  print(("  coverage %.4f of the cells in reach (nan: not counted), walked %.2f x the length of all corridors"):format(
    line.coverage, line.walked_over_corridors))
else
  local share, low, high = meander.study.wilson(line.n - line.failed, line.n)
  print(("  reached   in %d of %d (%.1f %%, 95 %% interval %.1f to %.1f)"):format(
    line.n - line.failed, line.n, 100 * share, 100 * low, 100 * high))
  print(("  false     unreachable %d, arrived %d"):format(line.false_unreachable, line.false_arrival))
  print(("  way       over the shortest, run 1 %.2f, run 2 %.2f, run 3 %.2f"):format(line.r1, line.r2, line.r3))
  print(("  route     the shortest in the end in %.1f %%; proven after %.1f runs"):format(100 * line.optimal, line.runs_to_proof))
end
print(("  graph     %.1f indicators; %.0f us per decision, walking included"):format(line.indicators, line.decision_us_median))

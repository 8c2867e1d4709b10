-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Explorers in many labyrinths: do they reach the goal, how long is the way in the first runs, when is the shortest route
-- proven? With --sensor graph the robot recognises every crossing: what the rules are worth, apart from what sonars hear.
-- With --sensor sonar a robot drives by what its sonars tell; nomad and real: sonars that do not hear walls seen aslant.
--
--   ./meander examples/labyrinth_study.lua --kind mixed --size 20 --loops 0.05 --seeds 100
--   ./meander examples/labyrinth_study.lua --size 10 --rules literal --seeds 100
--   ./meander examples/labyrinth_study.lua --size 20 --explorer indicator,tremaux,dstar_lite --seeds 100
--   ./meander examples/labyrinth_study.lua --size 20 --loops 0.1 --goal walled --seeds 100
--   ./meander examples/labyrinth_study.lua --sensor sonar --loops 0.08 --seeds 40
--   ./meander examples/labyrinth_study.lua --sensor sonar --loops 0.08 --seeds 40 --runs 1 --explorer all
local course = require "meander.labyrinth_course"
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "lets explorers explore labyrinths",
  { "--kind NAME", default = "mixed", values = { "backtracker", "prim", "mixed" }, help = "how the labyrinth grows" },
  { "--size N", default = 10, least = 2, most = 200, help = "cells along each side" },
  { "--loops P", default = 0.0, least = 0, most = 1, help = "share of inner walls that are taken away" },
  { "--rooms N", default = 0, least = 0, most = 1000, help = "so many times the walls inside a room are taken away" },
  { "--corridor M", default = 1.0, least = 0.5, most = 10, help = "width of the corridors, with sonars" },
  { "--jitter X", default = 0.0, least = 0, most = 0.25, help = "walls are crooked by so many widths, with sonars" },
  { "--seeds N", default = 20, least = 1, most = 100000, help = "labyrinths" },
  { "--first-seed N", default = 2001, least = 0, help = "seed of the first one" },
  { "--sensor NAME", default = "graph", values = { "graph", "sonar", "nomad", "real" }, help = "what the robot perceives by" },
  { "--drift NAME", default = "none", values = { "none", "good", "poor" }, help = "errors of the odometry, with sonars" },
  { "--perception NAME", default = "map", values = { "map", "profile" }, help = "what ports are read off, with sonars" },
  { "--rules NAME", default = "optimistic", values = { "literal", "repaired", "optimistic" }, help = "how the explorer reads the paper" },
  { "--explorer NAME,...", default = "indicator", help = "who decides: " .. table.concat(course.explorers, ", ") .. "; all; with several, differences to the first" },
  { "--eps X", default = 0.0, least = 0, most = 1, help = "stop when nothing can shorten the route by more" },
  { "--limit S", default = 4000.0, above = 0, help = "simulated seconds of a run, with sonars" },
  { "--runs N", default = 60, least = 1, most = 100000, help = "at most so many runs until the route is proven; with sonars at most 3" },
  { "--goal STATE", default = "open", values = { "open", "walled" }, help = "walled: no way leads to it" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "labyrinths at a time; 0: one per core" },
  { "--json", help = "one JSON object per explorer instead of text" },
  { "--out DIR", default = "", help = "folder of a table of all labyrinths, labyrinth_study.csv; left out: none" },
}
local file = options.out ~= "" and report.try(report.failure, nil, report.path, options, "labyrinth_study.csv")
local by_graph = options.sensor == "graph"
local absent = by_graph and { oracle = "is 1 without sensors; --sensor sonar" } or {}
local explorers = course.named(options.explorer, absent, report.usage_error)
if by_graph and options.runs < 3 then report.usage_error("--runs: at least 3 expected, got " .. options.runs) end

local function labyrinth(seed)
  local cells = meander.indicator.labyrinth {
    kind = options.kind, size = options.size, loops = options.loops, rooms = options.rooms, seed = seed,
  }
  if options.goal == "walled" then
    for _, side in ipairs { "west", "south" } do cells:set_open(options.size, options.size, side, false) end
  end
  return cells
end

-- Who explores the cells: a function that makes a run, one that says whether the shortest way is proven, and the explorer,
-- where it has a graph.
local function walker(name, cells, seed)
  if name == "dstar_lite" then
    local planner = cells:planner()
    return function() return planner:walk(cells) end, function() return planner.proven end
  end
  local explorer = meander.indicator.explorer {
    goal = cells.goal, explorer = name == "frontier" and "nearest" or name, rules = options.rules, eps = options.eps, seed = seed,
  }
  return function() return cells:explore(explorer) end, function() return explorer.state.proven end, explorer
end

-- One labyrinth, from the first run to the proof: a table of numbers.
local function walk(name, seed)
  local cells = labyrinth(seed)
  local shortest = cells:shortest()
  local run_once, proven, explorer = walker(name, cells, seed)
  local learns = name == "dstar_lite" or name == "indicator" and options.rules ~= "literal"
  local result = { shortest = shortest or false, failed = false, runs = {}, decisions = 0 }
  local began = os.clock()
  local last
  for run = 1, options.runs do
    last = run_once()
    result.runs[run] = last.length
    result.decisions = result.decisions + last.decisions
    local arrived = last.last.x == cells.goal.x and last.last.y == cells.goal.y
    result.false_arrival = result.false_arrival or (last.ending == "reached" and not arrived)
    result.failed = last.ending ~= "reached"
    if result.failed then break end
    if not result.proof and proven() then result.proof = run end
    if run >= 3 and (result.proof or not learns) then break end
  end
  result.us = (os.clock() - began) * 1e6 / result.decisions
  result.ending, result.reason, result.coverage = last.ending, last.reason, last.coverage
  if explorer then
    result.corridors = 0
    local _, length = explorer:route()
    result.optimal = shortest ~= nil and length ~= nil and math.abs(length - shortest) < 1e-6
    result.indicators = #explorer:graph()
    for _, link in ipairs(explorer:graph().links) do result.corridors = result.corridors + link.length end
  else
    result.optimal = last.length == shortest
  end
  return result
end

-- Metres of corridors that lead from cell to cell.
local function corridors(cells)
  local passages = 0
  for y = 1, options.size do
    for x = 1, options.size do
      for _, side in ipairs { "east", "north" } do passages = passages + (cells:open(x, y, side) and 1 or 0) end
    end
  end
  return passages * options.corridor
end

-- The same by sonar: what the robot drove, and where it truly is in the end.
local function drive(name, seed)
  local cells, width = labyrinth(seed), options.corridor
  local world = cells:world { corridor = width, jitter = options.jitter, seed = seed }
  local shortest = cells:shortest()
  local goal = { cells.goal.x * width, cells.goal.y * width }
  local explorer = name ~= "oracle" and meander.indicator.sonar_explorer(course.explorer {
    name = name, goal = goal, sensor = options.sensor, perception = options.perception, rules = options.rules,
    eps = options.eps, seed = seed,
  })
  local result = { shortest = shortest and shortest * width or false, failed = false, runs = {} }
  for _, key in ipairs { "contacts", "fault_contacts", "blocked", "looks", "cpu" } do result[key] = 0 end
  for run = 1, math.min(options.runs, 3) do
    local last = course.drive {
      world = world, explorer = explorer or nil, plan = not explorer and course.plan_of(world), goal = goal,
      seed = 10 * seed + run, sensor = options.sensor, drift = options.drift, limit = options.limit,
    }
    result.runs[run] = last.way
    for _, key in ipairs { "contacts", "fault_contacts", "cpu" } do result[key] = result[key] + last[key] end
    result.ending, result.reason = last.ending, last.reason
    result.false_arrival = result.false_arrival or last.false_arrival
    result.failed = last.ending ~= "reached" or last.false_arrival
    if explorer then result.blocked, result.looks = result.blocked + explorer.blocked, result.looks + explorer.second_looks end
    if result.failed then break end
    if not result.proof and explorer and explorer.proven then result.proof = run end
  end
  result.corridors = corridors(cells)
  if not explorer then return result end
  result.us = result.cpu * 1e6 / math.max(explorer.decisions, 1)
  local length = explorer:route()
  if length and shortest then result.optimal = length < 1.05 * result.shortest end
  result.indicators = #explorer:graph() > 0 and #explorer:graph() or nil
  return result
end

local seeds = {}
for i = 1, options.seeds do seeds[i] = options.first_seed + i - 1 end
local function trials(name)
  local results = {}
  local trial = by_graph and walk or drive
  local all = meander.study.trials { trial = function(seed) return trial(name, seed) end, seeds = seeds, jobs = options.jobs }
  for i, one in ipairs(all) do
    if not one.ok then report.failure("seed " .. one.seed .. ": " .. one.error) end
    results[i] = one.value
  end
  return results
end

local function rounded(x) return x == x and tonumber(("%.4f"):format(x)) or x end
local nan = 0 / 0

-- Numbers of the labyrinths for which `value` gives one: mean and ends of its interval; no number: null in JSON.
local function mean(results, value)
  local list = {}
  for _, result in ipairs(results) do list[#list + 1] = value(result) or nil end
  if #list == 0 then return nan, nan, nan end
  local middle, low, high = meander.study.bootstrap_mean(list)
  return rounded(middle), rounded(low), rounded(high)
end
local function ratio(result, run)
  return result.shortest and not result.failed and result.runs[run] and result.runs[run] / result.shortest
end

local keys = {
  "kind", "size", "loops", "sensor", "rules", "explorer", "n", "failed", "false_unreachable", "false_arrival", "r1", "r2",
  "r3", "runs_to_proof", "optimal", "indicators", "decision_us_median", "r1_interval", "r2_interval", "r3_interval", "causes",
}
if not by_graph then
  table.move({ "contacts", "fault_contacts", "blocked", "looks", "rooms", "corridor", "drift", "perception" }, 1, 8, #keys + 1, keys)
end
if options.goal == "walled" then table.move({ "stated", "coverage", "walked_over_corridors" }, 1, 3, #keys + 1, keys) end

local function summary(name, results)
  local function count(test)
    local n = 0
    for _, result in ipairs(results) do n = n + (test(result) and 1 or 0) end
    return n
  end
  local function average(key) return (mean(results, function(r) return r[key] end)) end
  local us = {}
  for _, result in ipairs(results) do us[#us + 1] = result.us end
  local line = {
    kind = options.kind, size = options.size, loops = options.loops, sensor = options.sensor, rules = options.rules,
    explorer = name, n = #results,
    failed = count(function(r) return r.shortest and r.failed end),
    false_unreachable = count(function(r) return r.shortest and r.ending == "no_passable_direction" end),
    false_arrival = count(function(r) return r.false_arrival end),
    runs_to_proof = average "proof",
    optimal = (mean(results, function(r) return r.optimal ~= nil and (r.optimal and 1.0 or 0.0) end)),
    indicators = average "indicators",
    decision_us_median = #us > 0 and rounded(meander.study.median(us)) or nan,
    causes = { time = 0, trapped = 0, budget = 0, no_passable_direction = 0, false_arrival = 0 },
    rooms = options.rooms, corridor = options.corridor, drift = options.drift, perception = options.perception,
    stated = count(function(r) return not r.shortest and r.ending == "no_passable_direction" end),
    coverage = average "coverage",
    walked_over_corridors = (mean(results, function(r) return not r.shortest and r.corridors and r.runs[1] / r.corridors end)),
  }
  for _, key in ipairs { "contacts", "fault_contacts", "blocked", "looks" } do line[key] = average(key) end
  for run = 1, 3 do
    local low, high
    line["r" .. run], low, high = mean(results, function(r) return ratio(r, run) end)
    line["r" .. run .. "_interval"] = { low, high }
  end
  for _, result in ipairs(results) do
    if result.shortest and result.failed then
      local cause = result.false_arrival and "false_arrival" or result.ending
      line.causes[cause] = line.causes[cause] + 1
    end
  end
  return line
end

local function share(n, of)
  local part, low, high = meander.study.wilson(n, of)
  return ("%d of %d (%.1f %%, 95 %% interval %.1f to %.1f)"):format(n, of, 100 * part, 100 * low, 100 * high)
end

-- Figures that were not counted for this explorer stay away.
local function known(text, ...)
  for i = 1, select("#", ...) do
    local x = select(i, ...)
    if x ~= x then return "" end
  end
  return text:format(...)
end

local function tell(line, results)
  local name = line.explorer == "indicator" and options.rules .. " rules" or line.explorer
  print(("%d %s labyrinths of %d x %d cells, loops %g: %s"):format(line.n, options.kind, options.size, options.size, options.loops, name))
  if options.goal == "walled" then
    print("  unreachable, and stated so in " .. share(line.stated, line.n))
    local walked = known("%.2f x the length of all corridors; ", line.walked_over_corridors)
      .. known("on %.4f of the cells in reach", line.coverage)
    print("  walked    " .. (walked:gsub("; $", "")))
  else
    print("  reached   in " .. share(line.n - line.failed, line.n))
    for i, result in ipairs(results) do
      if result.failed then
        local cause = result.false_arrival and "it is not where it says" or result.ending
        print(("  failed    seed %d: %s; %s"):format(seeds[i], cause, result.reason))
      end
    end
    print(("  false     unreachable %d, arrived %d"):format(line.false_unreachable, line.false_arrival))
    local runs = {}
    for run = 1, 3 do
      local ends = line[("r%d_interval"):format(run)]
      local text = known("run %d %.2f (%.2f to %.2f)", run, line["r" .. run], ends[1], ends[2])
      runs[#runs + 1] = text ~= "" and text or nil
    end
    print("  way       " .. (#runs > 0 and "over the shortest, " .. table.concat(runs, "  ") or "none arrived"))
    print("  route     " .. known("the shortest in the end in %.1f %%; ", 100 * line.optimal)
      .. (line.runs_to_proof == line.runs_to_proof and ("proven after %.1f runs"):format(line.runs_to_proof) or "none proven"))
  end
  if not by_graph then
    print(("  contacts  %.2f, by its own motion %.2f;%s"):format(line.contacts, line.fault_contacts,
      known(" ways found blocked %.1f, second looks %.1f", line.blocked, line.looks)))
  end
  local told = known("%.1f indicators; ", line.indicators)
    .. known("%.0f us per decision, " .. (by_graph and "walking" or "map and navigator") .. " included", line.decision_us_median)
  if told ~= "" then print("  graph     " .. told) end
end

-- The first runs of two explorers where both arrived.
local function compare(first, second)
  local a, b = {}, {}
  for i = 1, #seeds do
    local x, y = ratio(first[i], 1), ratio(second[i], 1)
    if x and y then a[#a + 1], b[#b + 1] = x, y end
  end
  if #a == 0 then return end
  local difference, low, high, longer, shorter = meander.study.compare(b, a)
  return difference, low, high, #a, longer, shorter
end

-- The table: one row for each labyrinth and explorer.
local columns = {
  "explorer", "seed", "ending", "false_arrival", "shortest", "run1", "run2", "run3", "runs_to_proof", "contacts", "fault_contacts", "reason",
}
local rows = { table.concat(columns, ",") }
local function add_rows(name, results)
  for i, r in ipairs(results) do
    local row = {
      name, seeds[i], r.ending, r.false_arrival and 1 or 0, r.shortest or "", r.runs[1] or "", r.runs[2] or "", r.runs[3] or "",
      r.proof or "", r.contacts or "", r.fault_contacts or "", '"' .. r.reason:gsub('"', '""') .. '"',
    }
    rows[#rows + 1] = table.concat(row, ",")
  end
end

local first
for _, name in ipairs(explorers) do
  local results = trials(name)
  add_rows(name, results)
  local line = summary(name, results)
  local difference, low, high, n, longer, shorter
  if first then difference, low, high, n, longer, shorter = compare(first, results) end
  if options.json then
    local more = table.move(keys, 1, #keys, 1, {})
    if difference then
      line.r1_more, line.r1_more_interval, line.paired = rounded(difference), { rounded(low), rounded(high) }, n
      table.move({ "r1_more", "r1_more_interval", "paired" }, 1, 3, #more + 1, more)
    end
    print(json.encode(line, more))
  else
    tell(line, results)
    if difference then
      print(("  run 1     %+.2f (%.2f to %.2f) against %s where both arrived (%d): longer in %d, shorter in %d"):format(
        difference, low, high, explorers[1], n, longer, shorter))
    end
  end
  first = first or results
end
if file then
  local out, why = io.open(file, "w")
  if not out then report.failure(why) end
  out:write(table.concat(rows, "\n"), "\n")
  out:close()
  if not options.json then print("table: " .. file) end
end

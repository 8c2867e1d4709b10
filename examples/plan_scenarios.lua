-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Holds the planners against the scenarios of movingai.com: A* must find ways of the published lengths, and the neural
-- map must have a way wherever A* has one. To scenarios, which all can be done, it adds starts drawn at random, of which
-- many cannot.
--
--   ./meander examples/plan_scenarios.lua arena.map.scen --json
--
-- The map is looked for beside the scenario file. Without a file, a small map of its own is checked.
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "holds A* and the neural map against the scenarios of movingai.com",
  { "--json", help = "one JSON object per file instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures: the longest scenario of each map, on the neural map" },
  { "--every N", default = 1, least = 1, help = "only every N-th scenario" },
  { "--tolerance CELLS", default = 0.001, least = 0, help = "largest difference of lengths that matches" },
  { "--solver NAME", default = "tiles", values = { "tiles", "active_list" }, help = "of the neural map" },
  { "FILE.scen ...", help = "scenario files", rest = true },
}

-- A map with a closed room, and tasks whose lengths were counted by hand.
local function own_files()
  local stem = os.tmpname()
  local map = assert(io.open(stem .. ".map", "w"))
  map:write "type octile\nheight 5\nwidth 8\nmap\n....@...\n.@@.@...\n.@..@@@@\n.@@.....\n........\n"
  map:close()
  local tasks = assert(io.open(stem .. ".map.scen", "w"))
  tasks:write("version 1\n", ("0 own.map 8 5 0 0 3 0 3\n1 own.map 8 5 0 0 0 4 4\n2 own.map 8 5 3 1 7 3 %.8f\n"):format(2 + 4))
  tasks:close()
  return stem .. ".map.scen"
end

local function reaches(map, start, goal)
  local plan = meander.planning.plan { map = map, start = start, target = goal, solver = options.solver, path = "steepest" }
  return plan ~= nil
end
local function way(map, start, goal)
  return meander.planning.plan { map = map, start = start, target = goal, planner = "astar" }
end

local function check(file, name)
  local map = report.try(report.failure, nil, meander.planning.read_map, (file:gsub("%.scen$", "")))
  local tasks = report.try(report.failure, nil, map.scenarios, map, file)
  local count, matched, worst, agree, random, cut_off, longest = 0, 0, 0, true, 0, 0, nil
  for i = 1, #tasks, options.every do
    local task = tasks[i]
    local plan = way(map, task.start, task.goal)
    count = count + 1
    if plan then
      local difference = math.abs(plan.measures.length - task.length)
      worst = math.max(worst, difference)
      if difference <= options.tolerance then matched = matched + 1 end
      if not longest or task.length > longest.length then longest = task end
    end
    if reaches(map, task.start, task.goal) ~= (plan ~= nil) then agree = false end
    if count % 5 == 1 then
      -- Any cell: often in a wall or cut off.
      local other = { (i * 7919 % map.width) + 0.5, (i * 104729 % map.height) + 0.5 }
      local there = way(map, other, task.goal) ~= nil
      random, cut_off = random + 1, cut_off + (there and 0 or 1)
      if reaches(map, other, task.goal) ~= there then agree = false end
    end
  end
  if longest then
    local plan = meander.planning.plan { map = map, start = longest.start, target = longest.goal, solver = options.solver }
    if plan then meander.render.save(plan, report.path(options, "plan_scenarios_" .. name .. ".svg")) end
  end
  return {
    map = name, scenarios = count, matched = matched, max_difference = worst,
    reachable_agree = agree, random_starts = random, without_way = cut_off,
  }
end

local files, own = options.rest
if #files == 0 then
  own = own_files()
  files = { own }
end
local failed = false
for _, file in ipairs(files) do
  local result = check(file, own and "own" or file:match("([^/]*)%.map%.scen$") or file:match("[^/]*$"))
  failed = failed or result.matched < result.scenarios or not result.reachable_agree
  if options.json then
    print(json.encode(result))
  else
    print(("%s: %d of %d lengths match (largest difference %.6f), reachability %s, also from %d random starts"):format(
      result.map, result.matched, result.scenarios, result.max_difference,
      result.reachable_agree and "agrees" or "DIFFERS", result.random_starts))
    if result.matched > 0 then print("picture: " .. options.out .. "/plan_scenarios_" .. result.map .. ".svg") end
  end
end
if own then
  os.remove(own)
  os.remove((own:gsub("%.scen$", "")))
end
if failed then report.failure "not all scenarios are met" end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A robot that has never seen a building finds its way to a point in it by sonar. Ways are told over those that a planner
-- finds which knows the whole plan.
--
--   ./meander examples/explore_map.lua worlds/office.toml 6.0,4.5 --start 1.0,1.0
--   ./meander examples/explore_map.lua depot.yaml random --pairs 20 --explorer indicator,frontier
--   ./meander examples/explore_map.lua worlds/office.toml random --pairs 20 --through doors --explorer all
local course = require "meander.labyrinth_course"
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "explores a floor plan by sonar",
  { "--seed N", default = 2001, help = "of the pairs and of all noise" },
  { "--pairs N", default = 5, least = 1, most = 10000, help = "starts and goals drawn at random, where GOAL is random" },
  { "--start X,Y", default = "", help = "start; left out: that of the map" },
  { "--explorer NAME,...", default = "indicator", help = "who explores: " .. table.concat(course.explorers, ", ") .. "; all; with several, differences to the first" },
  { "--sonar NAME", default = "sonar", values = { "sonar", "nomad", "real" }, help = "what is heard: see lua/labyrinth_course.lua" },
  { "--drift NAME", default = "none", values = { "none", "good", "poor" }, help = "errors of the odometry" },
  { "--far M", default = 4.0, least = 0, help = "random goals are so far by the way at least" },
  { "--through PLACES", default = "any", values = { "any", "doors" }, help = "doors: the shortest way between random places is narrower than --wide somewhere" },
  { "--wide M", default = 1.3, above = 0, help = "a door is narrower than this" },
  { "--resolution M", default = 0.05, above = 0, help = "metres per pixel of a plain image" },
  { "--limit S", default = 3000.0, above = 0, help = "simulated seconds of a run" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "drives at a time; 0: one per core" },
  { "--json", help = "one JSON object per explorer instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
  { "MAP", default = "worlds/office.toml", help = "map file" },
  { "GOAL", default = "random", help = "X,Y or random" },
}
local explorers = course.named(options.explorer, {}, report.usage_error)

local function point(text, what)
  local x, y = text:match("^(%-?[%d.]+),(%-?[%d.]+)$")
  if not (tonumber(x) and tonumber(y)) then report.usage_error(what .. ": X,Y expected, got '" .. text .. "'") end
  return { tonumber(x), tonumber(y) }
end
local start = options.start ~= "" and point(options.start, "--start")
local goal = options.GOAL ~= "random" and point(options.GOAL, "GOAL")

local world = report.try(report.failure, nil, meander.world.import, options.MAP, { resolution = options.resolution })
local map = course.plan_of(world)
local radius = course.robot.body.radius

-- Length of the way of one who knows the plan; nil: there is none.
local function shortest(from, to, clear)
  local ok, plan = pcall(meander.planning.plan, { map = map, start = from, target = to, robot_radius = clear })
  return ok and plan and plan.measures.length or nil
end

local random = require "meander.stream"(options.seed)
local function somewhere()
  local low, high = world.bounds[1], world.bounds[2]
  return { low.x + random() * (high.x - low.x), low.y + random() * (high.y - low.y) }
end

-- Both ends have room, but the shortest way leads through a place that is narrower than a door may be wide.
local function through_door(from, to, length)
  local wide = options.wide / 2
  if not (shortest(from, from, wide) and shortest(to, to, wide)) then return false end
  local around = shortest(from, to, wide)
  return not around or around > 1.2 * length
end

local pairs_of = {}
local function try(from, to)
  local length = shortest(from, to, radius + 0.05)
  if length then pairs_of[#pairs_of + 1] = { start = from, goal = to, length = length } end
  return length
end
if goal then
  if not try(start or { world.start.x, world.start.y }, goal) then report.failure("no way leads from the start to the goal") end
else
  for _ = 1, 400 * options.pairs do
    if #pairs_of == options.pairs then break end
    local from, to = start or somewhere(), somewhere()
    local length = try(from, to)
    if length and (length < options.far or options.through == "doors" and not through_door(from, to, length)) then
      pairs_of[#pairs_of] = nil
    end
  end
  if #pairs_of == 0 then report.failure("no starts and goals found that are " .. options.far .. " m apart") end
end

local function drive(name, index)
  local pair = pairs_of[index]
  local explorer = name ~= "oracle" and meander.indicator.sonar_explorer(course.explorer {
    goal = pair.goal, sensor = options.sonar, name = name, seed = options.seed,
  })
  local result = course.drive {
    world = world, explorer = explorer or nil, plan = map, goal = pair.goal, seed = options.seed * 100 + index,
    sensor = options.sonar, drift = options.drift, limit = options.limit, start = { pair.start[1], pair.start[2], 0 },
  }
  result.ratio = result.way / pair.length
  result.arrived = result.ending == "reached" and not result.false_arrival
  if explorer then
    result.picture = report.path(options, ("explore_map_%s_%d.svg"):format(name, index))
    meander.render.save(explorer:graph():over(world), result.picture)
  end
  return result
end

local function rounded(x) return x == x and tonumber(("%.4f"):format(x)) or x end
local nan = 0 / 0

local indices = {}
for i = 1, #pairs_of do indices[i] = i end
local function drives(name)
  local results = {}
  local all = meander.study.trials { trial = function(i) return drive(name, i) end, seeds = indices, jobs = options.jobs }
  for i, one in ipairs(all) do
    if not one.ok then report.failure("pair " .. i .. ": " .. one.error) end
    results[i] = one.value
  end
  return results
end

local function summary(name, results)
  local line = {
    map = options.MAP, pairs = #pairs_of, reached = 0, ratio_median = nan, ratio_interval = { nan, nan }, explorer = name,
    false_arrival = 0, false_unreachable = 0, contacts = 0, fault_contacts = 0,
    causes = { time = 0, trapped = 0, budget = 0, no_passable_direction = 0, false_arrival = 0 },
  }
  local ratios = {}
  for _, result in ipairs(results) do
    line.contacts, line.fault_contacts = line.contacts + result.contacts, line.fault_contacts + result.fault_contacts
    if result.arrived then
      line.reached = line.reached + 1
      ratios[#ratios + 1] = result.ratio
    else
      local cause = result.false_arrival and "false_arrival" or result.ending
      line.causes[cause] = line.causes[cause] + 1
    end
  end
  line.false_arrival, line.false_unreachable = line.causes.false_arrival, line.causes.no_passable_direction
  if #ratios > 0 then
    local middle, low, high = meander.study.bootstrap_median(ratios)
    line.ratio_median, line.ratio_interval = rounded(middle), { rounded(low), rounded(high) }
  end
  return line
end

local function tell(line, results)
  for i, result in ipairs(results) do
    local pair = pairs_of[i]
    local told = result.arrived and ("%.2f x the shortest way"):format(result.ratio) or result.reason
    print(("(%.1f, %.1f) to (%.1f, %.1f): %s after %.1f m; %s%s"):format(
      pair.start[1], pair.start[2], pair.goal[1], pair.goal[2], result.false_arrival and "not where it says" or result.ending,
      result.way, told, result.picture and "; " .. result.picture or ""))
  end
  local share, low, high = meander.study.wilson(line.reached, line.pairs)
  local way = line.reached == 0 and "" or (", median %.2f (%.2f to %.2f) x the shortest way"):format(
    line.ratio_median, line.ratio_interval[1], line.ratio_interval[2])
  print(("%s: %d of %d reached (%.1f %%, 95 %% interval %.1f to %.1f)%s; contacts %d, by its own motion %d"):format(
    line.explorer, line.reached, line.pairs, 100 * share, 100 * low, 100 * high, way, line.contacts, line.fault_contacts))
end

-- Where both arrived: mean of the ways' difference over the shortest, its interval, how many pairs.
local function compare(first, second)
  local a, b = {}, {}
  for i = 1, #pairs_of do
    if first[i].arrived and second[i].arrived then a[#a + 1], b[#b + 1] = first[i].ratio, second[i].ratio end
  end
  if #a == 0 then return end
  local difference, low, high = meander.study.compare(b, a)
  return rounded(difference), { rounded(low), rounded(high) }, #a
end

local keys = {
  "map", "pairs", "reached", "ratio_median", "ratio_interval", "explorer", "false_arrival", "false_unreachable", "contacts",
  "fault_contacts", "causes",
}
local first
for _, name in ipairs(explorers) do
  local results = drives(name)
  local line, more = summary(name, results), table.move(keys, 1, #keys, 1, {})
  if first then
    line.ratio_more, line.ratio_more_interval, line.paired = compare(first, results)
    table.move({ "ratio_more", "ratio_more_interval", "paired" }, 1, line.paired and 3 or 0, #more + 1, more)
  end
  if options.json then
    print(json.encode(line, more))
  else
    tell(line, results)
    if line.paired then
      print(("  %+.2f (%.2f to %.2f) against %s where both arrived (%d)"):format(
        line.ratio_more, line.ratio_more_interval[1], line.ratio_more_interval[2], explorers[1], line.paired))
    end
  end
  first = first or results
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A robot that has never seen a building finds its way to a point in it by sonar. Ways are told over those that a planner
-- finds which knows the whole plan.
--
--   ./meander examples/explore_map.lua worlds/office.toml 6.0,4.5 --start 1.0,1.0
--   ./meander examples/explore_map.lua depot.yaml random --pairs 20 --explorer frontier
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "explores a floor plan by sonar",
  { "--seed N", default = 2001, help = "of the pairs and of all noise" },
  { "--pairs N", default = 5, help = "starts and goals drawn at random, where GOAL is random" },
  { "--start X,Y", default = "", help = "start; left out: that of the map" },
  { "--explorer NAME", default = "indicators", values = { "indicators", "free_space", "frontier", "goal_frontier" }, help = "who chooses" },
  { "--sonar NAME", default = "sonar", values = { "sonar", "nomad", "real" }, help = "what is heard: see lua/labyrinth_course.lua" },
  { "--far M", default = 4.0, help = "random goals are so far by the way at least" },
  { "--resolution M", default = 0.05, help = "metres per pixel of a plain image" },
  { "--limit S", default = 3000.0, help = "simulated seconds of a run" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
  { "MAP", default = "worlds/office.toml", help = "map file" },
  { "GOAL", default = "random", help = "X,Y or random" },
}
local course = require "meander.labyrinth_course"

local function point(text, what)
  local x, y = text:match("^(%-?[%d.]+),(%-?[%d.]+)$")
  if not (tonumber(x) and tonumber(y)) then report.usage_error(what .. ": X,Y expected, got '" .. text .. "'") end
  return { tonumber(x), tonumber(y) }
end

local world = meander.world.import(options.MAP, { resolution = options.resolution })
local map = meander.planning.map { world = world, resolution = 0.05 }
local radius = course.robot.body.radius

-- The way of one who knows the plan; nil: there is none.
local function shortest(start, goal)
  local ok, plan = pcall(meander.planning.plan, { map = map, start = start, target = goal, robot_radius = radius + 0.05 })
  return ok and plan and plan.measures.length or nil
end

-- A sequence of numbers that depends on the seed alone (Lehmer's generator).
local state = (options.seed * 7919 + 12345) % 2147483646 + 1
local function share()
  state = state * 48271 % 2147483647
  return state / 2147483647
end
local function somewhere()
  local low, high = world.bounds[1], world.bounds[2]
  return { low.x + share() * (high.x - low.x), low.y + share() * (high.y - low.y) }
end

local pairs_of = {}
if options.GOAL == "random" then
  for _ = 1, 2000 do
    if #pairs_of == options.pairs then break end
    local start, goal = somewhere(), somewhere()
    local length = shortest(start, goal)
    if length and length >= options.far then pairs_of[#pairs_of + 1] = { start = start, goal = goal, length = length } end
  end
else
  local start = options.start ~= "" and point(options.start, "--start") or { world.start.x, world.start.y }
  local goal = point(options.GOAL, "GOAL")
  local length = shortest(start, goal)
  if not length then report.failure("no way leads from the start to the goal") end
  pairs_of[1] = { start = start, goal = goal, length = length }
end
if #pairs_of == 0 then report.failure("no starts and goals found that are " .. options.far .. " m apart") end

local function drive(index)
  local pair = pairs_of[index]
  local explorer = meander.indicator.sonar_explorer(course.explorer {
    goal = pair.goal, sensor = options.sonar, strategy = options.explorer,
  })
  course.run {
    world = world, explorer = explorer, seed = options.seed * 100 + index, sensor = options.sonar, limit = options.limit,
    start = { pair.start[1], pair.start[2], 0 },
  }
  local picture = report.path(options, ("explore_map_%d.svg"):format(index))
  meander.render.save(explorer:graph():over(world), picture)
  return { ending = explorer.ending, ratio = explorer.walked / pair.length, walked = explorer.walked, picture = picture }
end

local reached, ratios = 0, {}
for i, pair in ipairs(pairs_of) do
  local result = drive(i)
  if result.ending == "reached" then
    reached = reached + 1
    ratios[#ratios + 1] = result.ratio
  end
  if not options.json then
    print(("(%.1f, %.1f) to (%.1f, %.1f): %s after %.1f m, %.2f x the shortest way; %s"):format(
      pair.start[1], pair.start[2], pair.goal[1], pair.goal[2], result.ending == "driving" and "time" or result.ending,
      result.walked, result.ratio, result.picture))
  end
end
local median = #ratios > 0 and meander.study.median(ratios) or 0 / 0
if options.json then
  print(json.encode({ map = options.MAP, pairs = #pairs_of, reached = reached, ratio_median = median }, { "map", "pairs", "reached", "ratio_median" }))
else
  print(("%d of %d reached, median %.2f x the shortest way"):format(reached, #pairs_of, median))
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Global and local navigation together: a neural map over the floor plan gives the path, the polar neural map drives along
-- it by sonar. The guide knows the map; the robot starts where the map's frame is its odometry's.
--
--   ./meander examples/drive_planned.lua worlds/office.toml  START_X START_Y  X Y
--   ./meander examples/drive_planned.lua depot.yaml --seeds 20 --hidden 4
--
-- Metres in the frame of the map. Without points, each seed draws a start and a goal of its own. --hidden puts boxes on the
-- path that the map does not show, where a way past them is left; the drive is told over the shortest way for one who knows them.
local json = require "meander.json"
local report = require "meander.report"

-- All navigators drive by sonar.
local robots = {}
for _, name in ipairs(meander.robot.platforms()) do
  robots[#robots + 1] = meander.robot.platform(name).sonar.count > 0 and name or nil
end

local options = require "meander.arguments" {
  about = "plans on a map, drives by sonar; of two points the first is the start",
  { "--seed N", default = 7, least = 0, most = 1000000000, help = "seed of all random streams; the first of several" },
  { "--seeds N", default = 1, least = 1, most = 100000, help = "drives, each with a seed of its own" },
  { "--json", help = "one JSON object per drive, and one for all of several, instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures and the record" },
  { "--heading DEG", default = 0.0, help = "heading at the start, in degrees" },
  { "--resolution M", default = 0.05, least = 0.001, most = 1000, help = "side of the planner's cells; metres per pixel of a plain image" },
  { "--unknown HOW", default = "auto", values = { "auto", "free", "occupied" }, help = "unknown cells of a ROS map" },
  { "--index N", default = 0, least = 0, help = "which world of a BARN file" },
  { "--navigator NAME", default = "polar", values = meander.autonomy.navigators(), help = "who drives" },
  { "--planner NAME", default = "neural_map", values = meander.planning.planners(), help = "who plans" },
  { "--robot NAME", default = "nomad200", values = robots, help = "kind of robot" },
  { "--sonar NAME", default = "nomad", values = meander.sensor.sonars(), help = "sonar preset" },
  { "--hidden N", default = 0, least = 0, most = 100, help = "boxes of 30 cm on the path that the map does not show" },
  { "--gap M", default = 0.9, above = 0, help = "a way of this width is left beside them" },
  { "--far M", default = 5.0, least = 0, help = "points that are drawn are so far apart, by the way" },
  { "--deaf", help = "the guide does not listen to the sonars: it knows the map alone" },
  { "--time-limit S", default = 600.0, above = 0, most = 1000000000, help = "simulated seconds until the drive is given up" },
  { "MAP", help = "map file", default = "worlds/office.toml" },
  { "X Y ...", help = "start and goal in metres", rest = true },
}

local words = options.rest
if #words ~= 4 and #words ~= 0 then
  report.usage_error("START_X START_Y X Y expected behind the map, or nothing, got " .. #words .. " word(s)")
end
for _, word in ipairs(words) do
  if not tonumber(word) then report.usage_error("a number of metres expected, got '" .. word .. "'") end
end
if options.gap < 2 * meander.robot.platform(options.robot).body.radius then
  report.usage_error("--gap: a way that the robot fits through expected, got " .. options.gap)
end

local original, notes = report.try(report.failure, nil, meander.world.import, options.MAP, {
  resolution = options.resolution, unknown = options.unknown, index = options.index,
})
report.try(report.failure, nil, meander.make_folder, options.out)
for _, line in ipairs(notes) do io.stderr:write(line, "\n") end

local radius = meander.robot.platform(options.robot).body.radius
local map = meander.planning.map { world = original, resolution = options.resolution }

local function path(on, task, body, planner)
  return meander.planning.plan { map = on, start = task.start, target = task.goal, robot_radius = body, planner = planner }
end

-- A sequence of numbers from 0 to 1 that depends on the seed alone (Lehmer's generator).
local function draws(seed)
  local state = (seed * 7919 + 12345) % 2147483646 + 1
  return function()
    state = state * 48271 % 2147483647
    return state / 2147483647
  end
end

-- Start and goal, and the path on the map: with 10 cm to spare, or without.
local function task_of(seed)
  if #words == 4 then
    local task = { start = { tonumber(words[1]), tonumber(words[2]) }, goal = { tonumber(words[3]), tonumber(words[4]) } }
    local plan, why = path(map, task, radius + 0.1, options.planner)
    if not plan then plan, why = path(map, task, radius, options.planner) end
    if not plan then report.failure(why) end
    task.plan, task.heading = plan, options.heading
    return task
  end
  local share, low, high = draws(seed), original.bounds[1], original.bounds[2]
  local function somewhere()
    local x, y
    for _ = 1, 10000 do
      x, y = low.x + share() * (high.x - low.x), low.y + share() * (high.y - low.y)
      if not map:solid(x, y) then break end
    end
    return { x, y }
  end
  for _ = 1, 500 do
    local task = { start = somewhere(), goal = somewhere() }
    task.plan = path(map, task, radius + 0.1, options.planner)
    if task.plan and task.plan.measures.length >= options.far then
      task.heading = 360 * share()
      return task
    end
  end
  report.failure("no start and goal found that are " .. options.far .. " m apart")
end

-- What the map does not know: boxes on the path, spread along it and off its middle by up to 30 cm, where a way is left for
-- a body as wide as the gap. The world with them, and how many there are.
local function hide(task, seed)
  local world = original:fork()
  local truth, share, hidden = meander.planning.map { map = map }, draws(seed + 500000), 0
  local points = task.plan.path
  for i = 1, options.hidden do
    for _ = 1, 20 do
      local at = points[math.max(1, math.floor((i - 0.5 + share()) * #points / (options.hidden + 1)))]
      local x, y = at.x + 0.6 * share() - 0.3, at.y + 0.6 * share() - 0.3
      local box = { { x - 0.15, y - 0.15 }, { x + 0.15, y + 0.15 } }
      local tried = meander.planning.map { map = truth }
      tried:block(box)
      if path(tried, task, options.gap / 2) and pcall(world.add_box, world, { center = { x, y }, size = { 0.3, 0.3 } }) then
        truth, hidden = tried, hidden + 1
        break
      end
    end
  end
  return world, hidden, truth
end

local function drive(seed, cycles)
  local task = task_of(seed)
  local world, hidden, truth = hide(task, seed)
  local sim = meander.sim.new {
    world = world, robot = options.robot, sonar = options.sonar, seed = seed,
    start = { task.start[1], task.start[2], deg(task.heading) },
  }
  local guide = meander.autonomy.planned_route {
    map = map, target = task.goal, planner = options.planner, robot_radius = radius,
    robot = not options.deaf and options.robot or nil,
  }
  -- The guide knows the map: it finds the way out of traps, not the navigator along the walls.
  local navigator = options.navigator == "polar"
      and meander.polar.navigator { robot = options.robot, trap = { escapes = 0, patience = 8 } }
    or options.navigator
  local run = sim:drive { navigator = navigator, guide = guide, time_limit = options.time_limit, record_every = cycles }
  local shortest = path(truth, task, radius, "theta_star")
  local figures = {
    success = run.success, planned_length = task.plan.measures.length, planned_clear = task.plan.clear, hidden = hidden,
    fault_contacts = run.fault_contacts, trapped = run.trapped, shortest = shortest and shortest.measures.length,
    ratio = shortest and run.length / shortest.measures.length,
  }
  return run, figures, task
end

if options.seeds == 1 then
  local run, figures, task = drive(options.seed)
  meander.render.save(task.plan, report.path(options, "drive_planned_plan.svg"))
  report.run("drive_planned", run, options, figures)
  if not options.json then
    local result = not run.success and "the goal is not reached: " .. run.reason
      or figures.ratio and ("%.2f x the shortest way"):format(figures.ratio) or "no shortest way is known"
    print(("%.2f m driven, %s; %d boxes that the map does not show"):format(run.length, result, figures.hidden))
  end
  os.exit(0, true)
end

local n, reached, contacts, ratios, hidden = 0, 0, 0, {}, 0
for seed = options.seed, options.seed + options.seeds - 1 do
  local run, figures, task = drive(seed, 0)
  n, contacts, hidden = n + 1, contacts + run.fault_contacts, hidden + figures.hidden
  if run.success then
    reached = reached + 1
    ratios[#ratios + 1] = figures.ratio
  end
  if options.json then
    figures.seed, figures.length, figures.time, figures.reason = seed, run.length, run.time, run.reason
    print(json.encode(figures))
  else
    local ratio = run.success and figures.ratio and (", %.2f x the shortest way"):format(figures.ratio) or ""
    print(("%d: (%.1f, %.1f) to (%.1f, %.1f): %s; %.1f m%s, %d contacts"):format(seed, task.start[1], task.start[2],
      task.goal[1], task.goal[2], run.reason, run.length, ratio, run.fault_contacts))
  end
end
local share, least, most = meander.study.wilson(reached, n)
local median = #ratios > 0 and meander.study.median(ratios) or 0 / 0
if options.json then
  print(json.encode {
    map = options.MAP, n = n, reached = reached, share = share, share_low = least, share_high = most,
    fault_contacts = contacts, ratio_median = median, hidden = hidden / n,
  })
else
  local way = #ratios > 0 and (", median %.2f x the shortest way"):format(median) or ""
  print(("%d of %d reached (%.0f %%, %.0f to %.0f %%), %d contacts by own fault%s, %.1f boxes each"):format(
    reached, n, 100 * share, 100 * least, 100 * most, contacts, way, hidden / n))
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A small robot that explores corridors of 1 m by sonar: shared by the examples that let one do so.
local pretty = require "meander.pretty"

local course = {}

-- A disc of 0.2 m with the limits of a Nomad 200.
course.robot = {
  name = "nomad200", body = { radius = 0.2 }, sonar = { radius = 0.17 }, bumper = { radius = 0.2 },
}
-- `sonar`: cones that hear the nearest thing inside them, with the noise of a Nomad 200. `nomad`, `real`: walls that are
-- seen aslant are not heard; then silence says little.
course.sensors = { sonar = { incidence = false, corner_range = 0, firing = "simultaneous" }, nomad = "nomad", real = "real" }
course.silence = { sonar = 3, nomad = 0.8, real = 0.8 }

-- Who explores: the indicators' rules; others that decide over the same ports; others that have the same map and no graph;
-- one that knows the world.
course.explorers = {
  "indicator", "tremaux", "depth_first", "nearest", "random_walk", "dstar_lite", "frontier", "goal_frontier", "oracle",
}

-- The names in a text like "indicator,oracle", or all that there are; `absent` says why one cannot be had, `leave` is told
-- of mistakes.
function course.named(text, absent, leave)
  local names = {}
  if text == "all" then
    for _, name in ipairs(course.explorers) do names[#names + 1] = not absent[name] and name or nil end
    return names
  end
  for name in (text .. ","):gmatch "([^,]*)," do
    local found = false
    for _, known in ipairs(course.explorers) do found = found or known == name end
    if not found then
      leave(("--explorer: %s or all expected, got '%s'%s"):format(
        table.concat(course.explorers, ", "), name, meander.did_you_mean(name, course.explorers)))
    end
    if absent[name] then leave("--explorer " .. name .. ": " .. absent[name]) end
    names[#names + 1] = name
  end
  return names
end

-- What is wrong with options, or nil; `known`: those that there are, nil where others look at them.
local function mistake(options, known)
  if type(options) ~= "table" then return "table of options expected, got " .. pretty.text(options) end
  for key in pairs(known and options or {}) do
    local name, found = tostring(key), false
    for _, word in ipairs(known) do found = found or word == name end
    if not found then
      return ("unknown option '%s'%s (known: %s)"):format(name, meander.did_you_mean(name, known), table.concat(known, ", "))
    end
  end
  if not course.sensors[options.sensor or "sonar"] then
    return "option 'sensor': nomad, real or sonar expected, got " .. pretty.text(options.sensor)
  end
end

local of_a_task = {
  "world", "explorer", "guide", "seed", "sensor", "navigator", "drift", "start", "limit", "record_every", "goal", "plan",
}

-- The same of a task: there is a world, and an explorer or, called `other`, somebody else who leads.
local function mistake_of_task(task, other)
  local why = mistake(task, of_a_task)
  if why or (task.world and task[other]) then return why end
  if not task.world then return "option 'world': missing, world expected" end
  if not task.explorer then return ("option 'explorer': missing, explorer by sonar (or '%s') expected"):format(other) end
  local ok, guide = pcall(function() return task.explorer.guide end)
  return not (ok and guide) and "option 'explorer': explorer by sonar expected, got " .. pretty.text(task.explorer) or nil
end

local on_map = { dstar_lite = true, frontier = true, goal_frontier = true }

-- The options of an explorer on this robot; `options` are added to them. `name`: who explores.
function course.explorer(options)
  local why = mistake(options)
  if why then error("labyrinth_course.explorer: " .. why, 2) end
  local name = options.name or "indicator"
  local all = {
    robot = course.robot, map = { silence = course.silence[options.sensor or "sonar"] },
    strategy = on_map[name] and name or "indicators", explorer = on_map[name] and "indicator" or name,
  }
  for key, value in pairs(options) do
    if key ~= "sensor" and key ~= "name" then all[key] = value end
  end
  return all
end

-- One run: {world, explorer, seed, sensor, navigator, drift, start, limit, record_every} gives the run, and where the robot truly ended.
-- `guide` in the place of an explorer: somebody else leads.
function course.run(task)
  local why = mistake_of_task(task, "guide")
  if why then error("labyrinth_course.run: " .. why, 2) end
  local sim = meander.sim.new {
    world = task.world, robot = course.robot, sonar = course.sensors[task.sensor or "sonar"], seed = task.seed,
    drift = task.drift, start = task.start,
  }
  local run = sim:drive {
    navigator = task.navigator or meander.polar.navigator { robot = course.robot },
    guide = task.guide or task.explorer:guide(), time_limit = task.limit or 3000, record_every = task.record_every or 0,
  }
  return run, sim
end

-- A map of the world for one that knows it, and the guide along its shortest way: subgoals near by, so that it follows, and
-- nothing that is heard counts as not on the map.
function course.plan_of(world) return meander.planning.map { world = world, resolution = 0.05 } end
function course.oracle(map, goal)
  return meander.autonomy.planned_route {
    map = map, target = goal, robot_radius = course.robot.body.radius, margin = 0.2, reach = 1, mapped = 10, tolerance = 0.2,
  }
end

-- A run and what it was worth: the task of course.run, with `goal`, and `plan` in the place of an explorer for the oracle.
-- Gives ending ("time": it ran out), reason, way, contacts, fault_contacts (by the robot's own motion), off (how far from the
-- goal it truly is), false_arrival, and cpu, the seconds that navigator and guide took.
function course.drive(task)
  local why = mistake_of_task(task, "plan") or not task.goal and "option 'goal': missing, {x, y} expected"
  if why then error("labyrinth_course.drive: " .. why, 2) end
  local explorer = task.explorer
  task.guide = not explorer and course.oracle(task.plan, task.goal) or nil
  local run, sim = course.run(task)
  local robot = sim.robots[1]
  local off = math.sqrt((robot.pose.x - task.goal[1]) ^ 2 + (robot.pose.y - task.goal[2]) ^ 2)
  local ending = explorer and explorer.ending or run.success and "reached" or "trapped"
  local out_of_time = ending == "driving" or (not explorer and not run.success and run.time >= (task.limit or 3000))
  local told = explorer and not out_of_time and explorer.reason or ""
  local result = {
    ending = out_of_time and "time" or ending, reason = told ~= "" and told or run.reason, way = run.length,
    contacts = robot.contacts, fault_contacts = robot.fault_contacts, off = off,
    time = run.time, cpu = run.cpu_per_cycle * run.cycles,
  }
  result.false_arrival = result.ending == "reached" and off > 0.5
  return result
end

return course

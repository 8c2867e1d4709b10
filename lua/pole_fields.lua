-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Fields of poles as the BARN benchmark has them (Perille, Truong, Xiao and Stone 2020), and the robot that drives them: for
-- the benchmark itself (examples/barn.lua), and to tune on fields that are not the benchmark's.
--
--   local fields = require "meander.pole_fields"
--   local world, length = fields.make(7)
--   local result = fields.drive { world = world, length = length, navigator = "polar", robot = fields.robot(16, 2), seed = 7 }
local stream = require "meander.stream"

local fields = {}

local kCell, kCells = 0.15, 30 -- side of a cell [m], cells along a side of the field
local kLeft, kLower = -4.425, 5.175 -- centre of the first cell [m]
local kRadius = 0.075 -- of a pole [m]
local kStart, kGoalAhead = { -2.25, 3, math.pi / 2 }, 10
local kRoom = 0.42 -- a route keeps at least so far from all poles [m]

--- The robot of the study: a disc of 0.25 m that brakes as hard as it speeds up, ten control cycles a second.
function fields.robot(sonars, speed)
  local body = { radius = 0.25, v_max = speed, v_min = 0, w_max = 2.0, a_v = 2.0, a_w = 4.0 }
  return {
    name = "barn", body = body, period = 0.1, sonar = { count = sonars, radius = 0.23, first = 0 },
    bumper = { count = 0, radius = 0.25, first = 0 },
  }
end

--- A sonar preset whose cones are no wider than the ring's share of the circle.
function fields.sonar(preset, sonars)
  local sonar = meander.sensor.sonar(preset)
  sonar.half_cone = math.min(sonar.half_cone, math.pi / sonars)
  -- A ring that fires one by one would need more than a cycle: all at once, as rings on several boards do.
  sonar.firing = "simultaneous"
  return sonar
end

-- Options for this robot, found on fields.make(seed) with seeds below 1000, never on the benchmark's own worlds. The polar
-- map's are those of the slower Nomad, scaled: half of the largest speed in the slow zone, samples as dense on a braking way
-- three times as long.
local function options_for(name, robot)
  if name == "polar" then
    return { control = { soft_speed = robot.body.v_max / 2, samples = 24 }, map = { kappa = 20 } }
  elseif name == "vfh_plus" then
    return {
      window = 1.33, enlarge = 0.027, low = 0.242, high = 0.607, wide_valley = 9, heading_weight = 0.80, half_cone = 0.124,
      steering = { turn_gain = 3.5, margin = 0.095, headway = 0.345, caution = 0.276 }, memory = { scans = 9, contradictions = 3 },
    }
  elseif name == "dynamic_window" then
    return {
      heading_weight = 5.18, distance_weight = 0.395, speed_weight = 1.41, margin = 0.037, reach = 1.09, half_cone = 0.073,
      memory = { scans = 8, contradictions = 4 },
    }
  elseif name == "tangent_bug" then
    return {
      reach = 4, clearance = 0.1, jump = 0.306, constancy = 0.507, follow_look = 0.657, half_cone = 0.138,
      steering = { turn_gain = 1.8, margin = 0.068, headway = 0.42, caution = 0.08 }, memory = { contradictions = 2 },
    }
  elseif name == "potential_field" then
    return {
      influence = 1.5, repulsion = 0.00257, turn_gain = 0.79, margin = 0.012, headway = 0.098, caution = 0.024, half_cone = 0.2,
    }
  end
  return {}
end

--- A navigator for this robot.
function fields.navigator(name, robot)
  local options = options_for(name, robot)
  if options.half_cone then options.half_cone = math.min(options.half_cone, math.pi / robot.sonar.count) end
  options.robot = robot
  return meander.polar[name == "polar" and "navigator" or name](options)
end

--- Drives a field for 100 s at most. Options: world, length of the reference path [m], navigator, robot, sonar, seed and
--- record_every. Gives success, collided, time, trapped, the benchmark's metric success x OT / clip(AT, 2 OT, 8 OT), where
--- AT is the time taken and OT that of the reference path at 2 m/s, and the run.
function fields.drive(options)
  local sim = meander.sim.new {
    world = options.world, robot = options.robot, seed = options.seed,
    sonar = options.sonar or fields.sonar("nomad", options.robot.sonar.count),
  }
  local run = sim:drive {
    navigator = options.navigator, subgoals = { "goal" }, when_trapped = "insist", time_limit = 100, stop_on_contact = true,
    record_every = options.record_every or 0,
  }
  local success, best = run.success and run.contacts == 0, options.length / 2
  return {
    success = success, collided = run.contacts > 0, time = run.time, trapped = run.trapped,
    metric = success and best / math.max(2 * best, math.min(8 * best, run.time)) or 0,
  }, run
end

--- Length of a reference path [m]: from the start through the cells' centres to the goal, which lies 10 m ahead.
function fields.path_length(points)
  local length, before = 0, kStart
  local function to(x, y)
    length = length + math.sqrt((x - before[1]) ^ 2 + (y - before[2]) ^ 2)
    before = { x, y }
  end
  for _, at in ipairs(points) do to(at[1], at[2]) end
  to(kStart[1], kStart[2] + kGoalAhead)
  return length
end

local function index(column, row) return row * kCells + column end

-- Poles in the eight cells around; what lies beyond the sides counts as a pole.
local function around(filled, column, row)
  local count = 0
  for dy = -1, 1 do
    for dx = -1, 1 do
      local x, y = column + dx, row + dy
      if x < 0 or x >= kCells then
        count = count + 1
      elseif (dx ~= 0 or dy ~= 0) and y >= 0 and y < kCells and filled[index(x, y)] then
        count = count + 1
      end
    end
  end
  return count
end

-- A cellular automaton joins random cells to clumps: crowded ones fill, lonely ones empty.
local function draw(random)
  local filled, share = {}, 0.20 + 0.13 * random()
  for i = 0, kCells * kCells - 1 do filled[i] = random() < share end
  for _ = 1, 2 do
    local next = {}
    for row = 0, kCells - 1 do
      for column = 0, kCells - 1 do
        local count, i = around(filled, column, row), index(column, row)
        next[i] = count > 4 or (count > 1 and filled[i])
      end
    end
    filled = next
  end
  for row = 0, kCells - 1 do filled[index(0, row)], filled[index(kCells - 1, row)] = true, true end
  return filled
end

-- Which cells a route may use.
local function free_cells(filled)
  local near, reach = {}, math.ceil((kRoom + kRadius) / kCell)
  for dy = -reach, reach do
    for dx = -reach, reach do
      if kCell * math.sqrt(dx * dx + dy * dy) < kRoom + kRadius then near[#near + 1] = { dx, dy } end
    end
  end
  local free = {}
  for i = 0, kCells * kCells - 1 do free[i] = true end
  for row = 0, kCells - 1 do
    for column = 0, kCells - 1 do
      if filled[index(column, row)] then
        for _, offset in ipairs(near) do
          local x, y = column + offset[1], row + offset[2]
          if x >= 0 and x < kCells and y >= 0 and y < kCells then free[index(x, y)] = false end
        end
      end
    end
  end
  return free
end

-- Length of the shortest route from start to goal over the free cells, or nil: relaxed until nothing changes.
local function route(free)
  local reached, queue, ahead = {}, {}, 1
  local function place(i) return kLeft + kCell * (i % kCells), kLower + kCell * (i // kCells) end
  local function offer(i, length)
    if not free[i] or (reached[i] and reached[i] <= length + 1e-9) then return end
    reached[i] = length
    queue[#queue + 1] = i
  end
  for column = 0, kCells - 1 do
    local x, y = place(column)
    offer(column, math.sqrt((x - kStart[1]) ^ 2 + (y - kStart[2]) ^ 2))
  end
  while queue[ahead] do
    local i = queue[ahead]
    ahead = ahead + 1
    local column, row = i % kCells, i // kCells
    for dy = -1, 1 do
      for dx = -1, 1 do
        local x, y = column + dx, row + dy
        if x >= 0 and x < kCells and y >= 0 and y < kCells then
          offer(index(x, y), reached[i] + kCell * math.sqrt(dx * dx + dy * dy))
        end
      end
    end
  end
  local best
  for i = kCells * (kCells - 1), kCells * kCells - 1 do
    local x, y = place(i)
    local rest = math.sqrt((x - kStart[1]) ^ 2 + (y - kStart[2] - kGoalAhead) ^ 2)
    if reached[i] and (not best or reached[i] + rest < best) then best = reached[i] + rest end
  end
  return best
end

local function build(filled, seed)
  local world = meander.world.new {
    title = "poles " .. seed, note = "A field of poles drawn from seed " .. seed .. ".", start = kStart,
    bounds = { { -5.5, -1 }, { 1, 15 } },
  }
  world:add_place { name = "goal", position = { kStart[1], kStart[2] + kGoalAhead }, tolerance = 1 }
  local function pole(x, y) world:add_disc { center = { x, y }, radius = kRadius } end
  for i = 0, kCells * kCells - 1 do
    if filled[i] then pole(kLeft + kCell * (i % kCells), kLower + kCell * (i // kCells)) end
  end
  for column = 0, kCells - 1 do pole(kLeft + kCell * column, kRadius) end
  for k = 1, 33 do pole(kLeft, kRadius + kCell * k); pole(kLeft + kCell * (kCells - 1), kRadius + kCell * k) end
  return world
end

--- A field drawn from a seed, with a way through it for a disc of 0.42 m, and the length of that way [m].
function fields.make(seed)
  local random = stream(seed)
  while true do
    local filled = draw(random)
    local length = route(free_cells(filled))
    if length then return build(filled, seed), length end
  end
end

return fields

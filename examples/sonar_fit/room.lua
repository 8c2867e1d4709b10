-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A room that a recording may come from, and a robot that follows its wall on the left, as the recorded one did.
local room = {}

-- A small stream of numbers in [0, 1) per room, apart from every other (Park and Miller's minimal standard).
local function stream(seed)
  local state = seed * 7919 % 2147483647 + 1
  for _ = 1, 5 do state = state * 48271 % 2147483647 end
  return function(low, high)
    state = state * 48271 % 2147483647
    return low + (high - low) * (state / 2147483647)
  end
end

-- Boxes stand along the walls and in the middle, as furniture does; the lane along the wall is narrowed, not closed.
local function furnish(world, width, height, boxes, draw)
  local added = 0
  for _ = 1, 20 * boxes do
    if added == boxes then return end
    local size = { draw(0.2, 1.0), draw(0.2, 0.8) }
    local center = { draw(1.6, width - 1.6), draw(1.6, height - 1.6) }
    if draw(0, 1) < 0.4 then -- against a wall
      local side = math.floor(draw(0, 4))
      if side < 2 then
        center[1], size[1] = side == 0 and 0.1 or width - 0.1, draw(0.1, 0.4)
      else
        center[2], size[2] = side == 2 and 0.1 or height - 0.1, draw(0.1, 0.4)
      end
    end
    if pcall(world.add_box, world, { center = center, size = size, heading = draw(0, 1) < 0.5 and 0 or draw(0, 1.5) }) then
      added = added + 1
    end
  end
end

--- The room number `seed`: 3.5 to 7.5 m by 3 to 6 m with up to six boxes.
function room.new(seed)
  local draw = stream(seed)
  local width, height, boxes = draw(3.5, 7.5), draw(3, 6), math.floor(draw(0, 7))
  local world = meander.world.new {
    title = "room " .. seed,
    bounds = { { -0.2, -0.2 }, { width + 0.2, height + 0.2 } },
    start = { width / 2, 0.85, math.pi },
  }
  world:add_wall { points = { { 0, 0 }, { width, 0 }, { width, height }, { 0, height } }, closed = true, name = "walls" }
  furnish(world, width, height, boxes, draw)
  return world
end

-- The nearest range among the sensors within `half` of `bearing`.
local function nearest(ranges, bearing, half)
  local n, least = #ranges, math.huge
  local first = math.ceil((bearing - half) / (2 * math.pi) * n)
  local last = math.floor((bearing + half) / (2 * math.pi) * n)
  for k = first, last do least = math.min(least, ranges[k % n + 1]) end
  return least
end

--- Keeps the wall on the left at about `distance` (sensor to wall): forward, a little left, a little right, hard right.
function room.follower(distance, speed)
  return function(observation)
    local ranges = observation.sonar
    local ahead, left = nearest(ranges, 0, deg(30)), nearest(ranges, deg(80), deg(45))
    if ahead < distance + 0.35 then return 0.15 * speed, -0.5 end
    if left < distance - 0.05 then return 0.8 * speed, -0.25 end
    if left > distance + 0.05 then return 0.8 * speed, 0.25 end
    return speed, 0
  end
end

--- Frames that a robot with this sonar ring records while it follows the wall.
--- plan: frames, sensors, rate [Hz], ring [m], sonar (options), seed, distance [m], speed [m/s].
function room.record(world, plan)
  local sim = meander.sim.new {
    world = world,
    seed = plan.seed,
    sonar = plan.sonar,
    robot = {
      name = "recorder",
      body = { radius = 0.25, v_max = 1, w_max = 2 },
      sonar = { count = plan.sensors, radius = plan.ring },
      period = 1 / plan.rate,
    },
  }
  local follow, frames = room.follower(plan.distance, plan.speed), {}
  for t = 1, plan.frames do
    sim:step(follow(sim.observation))
    frames[t] = sim.observation.sonar:totable()
  end
  return frames
end

return room

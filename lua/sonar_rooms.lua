-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Rooms in which sonar maps are measured: 12 x 12 m as in the simulations of [CN], with inner walls, boxes and poles, made
-- anew from each seed.
--
--   local rooms = require "meander.sonar_rooms"
--   local room = rooms.make(7)
--   local sim = meander.sim.new { world = room.world, start = room:place(), seed = 7 }
local stream = require "meander.stream"

local rooms = {}

local kSide, kRoom = 12, 0.12 -- of the room, and around the hull of a robot that is placed [m]
local kReach = 0.2667 + kRoom -- of a Nomad 200 [m]
local kDraws = 1000

-- Numbers in [low, high) of this seed alone.
local function range(seed)
  local random = stream(seed)
  return function(low, high) return low + (high - low) * random() end
end

local function point(random, rim) return { random(rim, kSide - rim), random(rim, kSide - rim) } end

local function make_world(random)
  local world = meander.world.new { bounds = { { 0, 0 }, { kSide, kSide } } }
  world:add_wall { points = { { 0, 0 }, { kSide, 0 }, { kSide, kSide }, { 0, kSide } }, closed = true }
  for _ = 1, 5 do
    local turn = random(0, 1) < 0.7 and math.pi / 2 * math.floor(random(0, 2)) or random(-math.pi, math.pi)
    world:add_box { center = point(random, 1.5), size = { random(1.5, 4.5), 0.15 }, heading = turn }
  end
  for _ = 1, 8 do
    world:add_box { center = point(random, 0.8), size = { random(0.25, 1.2), random(0.25, 1.2) }, heading = random(-3, 3) }
  end
  for _ = 1, 8 do world:add_disc { center = point(random, 0.5), radius = random(0.06, 0.35) } end
  return world
end

local Room = {}
Room.__index = Room

-- Is there room for the robot, in all directions?
local function is_free(world, at)
  for k = 0, 23 do
    local ray = { world = world, from = at, heading = k * math.pi / 12, range = kReach }
    if meander.sensor.ray(ray) then return false end
  end
  -- Inside a solid, rays meet its border from within: only far away, unless it is large.
  local sim = pcall(meander.sim.new, { world = world, start = { at[1], at[2], 0 } })
  return sim
end

--- A pose {x, y, heading} where the robot stands freely; another at each call.
function Room:place()
  for _ = 1, kDraws do
    local at = point(self.random, 0.5)
    if is_free(self.world, at) then return { at[1], at[2], self.random(-math.pi, math.pi) } end
  end
  error("no free place in this room", 0)
end

--- A room of its own: `world`, and place() as often as wanted; the same seed, the same places.
function rooms.make(seed)
  local random = range(seed)
  return setmetatable({ world = make_world(random), random = random }, Room)
end

return rooms

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The situations on which local navigators are measured. A scene is made anew from each seed:
--
--   local scene = require("meander.scenes").make("u_trap", 7)
--   local sim = meander.sim.new { world = scene.world, start = scene.start, seed = 7 }
--   local run = sim:drive { navigator = "polar", subgoals = scene.subgoals, time_limit = scene.time_limit }
--
-- In shipped worlds the seed turns the robot at its start and moves it by up to 10 cm; clutter and people are drawn anew.
local stream = require "meander.stream"

local scenes = {}

local kRadius = 0.2667 -- of the Nomad 200, for which the routes are made [m]

local function between(random, low, high) return low + (high - low) * random() end

local function varied_start(world, random)
  local start = world.start
  return { start.x + between(random, -0.1, 0.1), start.y + between(random, -0.1, 0.1), between(random, -math.pi, math.pi) }
end

-- The named places as subgoals, with one tolerance [m].
local function subgoals(world, names, tolerance)
  local list = {}
  for i, name in ipairs(names) do
    local place = world:get(name)
    list[i] = { x = place.position[1], y = place.position[2], tolerance = tolerance, name = name }
  end
  return list
end

local function shipped(file, names, tolerance, time_limit, more)
  return function(seed)
    local random, world = stream(seed), meander.world.open("worlds/" .. file .. ".toml")
    local scene = { world = world, subgoals = subgoals(world, names, tolerance), time_limit = time_limit }
    for key, value in pairs(more or {}) do scene[key] = value end
    scene.start = varied_start(world, random)
    return scene, random
  end
end

local small = { disc_radius_min = 0.12, disc_radius_max = 0.35, box_side_min = 0.25, box_side_max = 0.9 }
local large = { disc_radius_min = 0.35, disc_radius_max = 0.7, box_side_min = 0.6, box_side_max = 1.4 }

-- Clutter of this density through which leads a route `room` wider on either side than the robot.
local function clutter(density, room, sizes)
  return function(seed)
    local options = { kind = "clutter", seed = seed, density = density, route = kRadius + room }
    for key, value in pairs(sizes) do options[key] = value end
    local world, why = meander.world.generate(options)
    if not world then return nil, why end
    local start = world.start
    return {
      world = world, subgoals = subgoals(world, { "goal" }, 0.1), time_limit = 240,
      start = { start.x, start.y, between(stream(seed), -math.pi, math.pi) },
    }
  end
end

local hall = shipped("people", { "north_east", "south_east", "north_west", "south_west" }, 0.25, 300)

-- A point of the hall in which a walker has room beside the pillars.
local function station(random)
  local x, y
  repeat
    x, y = between(random, 1.2, 7.8), between(random, 1.2, 7.8)
  until math.min(math.abs(x - 3), math.abs(x - 6)) + math.abs(y - 4.5) > 0.8
  return { x, y }
end

-- Six people, each on a round of three stations at 0.3 to 0.6 m/s, who start at least 1.5 m from the robot.
local function people(yields)
  return function(seed)
    local scene, random = hall(seed)
    for i = 1, 6 do
      local center
      repeat
        center = station(random)
      until (center[1] - scene.start[1]) ^ 2 + (center[2] - scene.start[2]) ^ 2 > 1.5 ^ 2
      scene.world:remove("walker_" .. i)
      scene.world:add_mover {
        name = "walker_" .. i, center = center, radius = 0.25, waypoints = { station(random), station(random) },
        yields = yields, speed = between(random, 0.3, 0.6),
      }
    end
    return scene
  end
end

local rooms = {
  "door_a", "hall", "door_b", "corner_b", "door_b", "door_c", "meeting", "door_c", "hall_east", "door_f", "window",
  "door_f", "door_e",
}
-- The world's own places in their order, for which the robot goes round walls that are longer than it sees.
local places = {
  "door_a", "hall", "door_b", "corner_b", "door_c", "meeting", "hall_east", "door_f", "window", "door_e", "rack", "door_d",
  "kitchen",
}
local doors = { "a_front", "a_behind", "b_front", "b_behind", "c_front", "c_behind", "corner", "corridor_end" }
local targets = { "target_1", "target_2", "target_3", "target_4" }

local list = {
  { "four_targets", shipped("four_targets", targets, 0.0254, 300), "four targets among boxes, to within an inch ([LM99] Figure 7 left)" },
  { "u_trap", shipped("u_trap", { "goal" }, 0.1, 180), "a U of 1.0 x 1.4 m within the sensing scope ([LM99] Figure 8 left)" },
  { "l_corner", shipped("l_corner", { "goal" }, 0.1, 180), "an L across the way ([LM99] Figure 4)" },
  { "office", shipped("office", rooms, 0.25, 600, { hand_over = 0.4 }), "13 subgoals through an office ([LM99] Figure 9)" },
  {
    "office_places", shipped("office", places, 0.25, 600, { hand_over = 0.4 }),
    "its 13 places in their order, walls longer than the scope between some",
  },
  { "doors", shipped("doors", doors, 0.15, 300), "three doorways of 0.9 m and a corridor" },
  { "clutter_10", clutter(0.10, 0.20, small), "clutter 10 %, a route 0.20 m wider than the robot on either side ([LM99] Figure 8 right)" },
  { "clutter_10_tight", clutter(0.10, 0.10, small), "the same, 0.10 m" },
  { "clutter_20", clutter(0.20, 0.20, large), "clutter 20 %, large objects, 0.20 m" },
  { "clutter_20_tight", clutter(0.20, 0.10, large), "the same, 0.10 m" },
  { "clutter_20_small", clutter(0.20, 0.10, small), "clutter 20 %, small objects, 0.10 m" },
  { "people", people(true), "six people who stop for the robot ([LM99] Figure 7 right)" },
  { "people_blind", people(false), "six people who do not" },
  { "large_u", shipped("large_u", { "goal" }, 0.25, 300), "a U of 4 x 6 m, larger than the scope" },
}

--- The names of all scenes, in order.
function scenes.names()
  local names = {}
  for i, entry in ipairs(list) do names[i] = entry[1] end
  return names
end

local function entry_of(name)
  for _, entry in ipairs(list) do
    if entry[1] == name then return entry end
  end
  error(("unknown scene '%s' (known: %s)"):format(tostring(name), table.concat(scenes.names(), ", ")), 3)
end

--- What a scene shows, in words.
function scenes.text(name) return entry_of(name)[3] end

--- The scene of this seed: world, start, subgoals, time_limit [s] and hand_over [m]; or nil and why there is none.
function scenes.make(name, seed)
  local scene, why = entry_of(name)[2](seed)
  if not scene then return nil, why end
  scene.hand_over = scene.hand_over or 0
  return scene
end

return scenes

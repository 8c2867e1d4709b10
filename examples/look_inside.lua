-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- One cycle of the polar navigator, opened up: what it heard, what it remembers, which units of its map are obstructed, how
-- activation spreads from the target around them, which subgoal it reads off, and what its command costs.
--
--   ./meander examples/look_inside.lua --after 9 --world worlds/l_corner.toml
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "looks into one cycle of the polar navigator",
  { "--after SECONDS", default = 6.0, least = 0, help = "drives so long before it looks" },
  { "--world FILE", default = "worlds/u_trap.toml", help = "where it drives, from the world's start" },
  { "--subgoal NAME", default = "goal", help = "a place of the world" },
  { "--memory N", default = 10, least = 1, most = 1000, help = "scans that are remembered" },
  { "--seed N", default = 1, least = 0, most = 1000000000, help = "seed of all random streams" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}

local world = report.try(report.failure, nil, meander.world.open, options.world)
local place = report.try(report.usage_error, nil, world.get, world, options.subgoal)

local navigator = meander.polar.navigator { memory = { scans = options.memory } }
local sim = meander.sim.new { world = world, seed = options.seed }
local goal = { x = place.position[1], y = place.position[2], tolerance = 0.1 }
local v, w, status, reason = navigator:step(sim.observation, goal)
while sim.time < options.after and status == "driving" do
  sim:step(v, w)
  v, w, status, reason = navigator:step(sim.observation, goal)
end

local inside = navigator:inspect()
local stem = report.path(options, "look_inside")
for _, suffix in ipairs { ".svg", ".png" } do meander.render.save(navigator, stem .. suffix) end
meander.render.save(sim, stem .. "_world.svg")

-- Bearing of a sector off the target's, to the left positive [degrees].
local function bearing(sector)
  local turns = (sector - 1) / inside.sectors
  return math.deg(2 * math.pi * (turns > 0.5 and turns - 1 or turns))
end

-- How far from the centre the straight way to the target is obstructed first [m]; nil: it is free. What lies behind the
-- target does not count.
local function blocked_at()
  for ring = 1, inside.target_ring do
    if inside.radii[ring] >= inside.target then return nil end
    if inside.obstructed[ring][1] > 0 then return inside.radii[ring] end
  end
end

-- Angle from -180 to 180 degrees.
local function degrees(angle) return math.deg(math.atan(math.sin(angle), math.cos(angle))) end

-- "12 degrees to its left", "ahead".
local function aside(angle, whose, ahead)
  if math.abs(angle) < 0.5 then return ahead end
  return ("%.0f degrees to %s"):format(math.abs(angle), whose:format(angle > 0 and "left" or "right"))
end

-- What the robot does about a subgoal so many degrees to its left.
local function turning(w, at)
  if math.abs(w) < 0.005 then return "it does not turn" end
  local way = ("turns %s at %.2f rad/s"):format(w > 0 and "left" or "right", math.abs(w))
  return w * at > 0 and "so it " .. way or "it " .. way .. " all the same: within a period nothing costs less"
end

-- Of what the objective adds to the distance that is left, the largest.
local function decisive(cost)
  local names = {
    { "heading", "not facing the subgoal" }, { "hard", "being nearer to something than it may" },
    { "soft", "passing through the slow zone" }, { "speed", "being fast in the slow zone" },
  }
  table.sort(names, function(a, b) return cost[a[1]] > cost[b[1]] end)
  return cost[names[1][1]] > 0.005 and names[1][2] or nil
end

local chosen, cost, blocked = inside.chosen, inside.cost, blocked_at()
local at, seen = inside.predicted, inside.subgoal
local facing = degrees(at.heading - inside.frame.heading)
local seen_at = seen and degrees(math.atan(seen.y - at.y, seen.x - at.x) - at.heading)
local seen_distance = seen and math.sqrt((seen.x - at.x) ^ 2 + (seen.y - at.y) ^ 2)
local total = cost.distance + cost.heading + cost.hard + cost.soft + cost.speed
if options.json then
  local keys = {
    "example", "seed", "time", "status", "target", "blocked_at", "direction", "facing", "subgoal_at", "subgoal_distance",
    "escaping", "v", "w", "objective", "residual", "picture",
  }
  local function rounded(x) return x and tonumber(("%.6f"):format(x)) end
  print(json.encode({
    example = "look_inside", seed = options.seed, time = rounded(sim.time), status = status,
    target = rounded(inside.target), blocked_at = rounded(blocked),
    direction = seen and rounded(bearing(seen.sector)), facing = rounded(facing), subgoal_at = rounded(seen_at),
    subgoal_distance = rounded(seen_distance), escaping = inside.escaping,
    v = rounded(v), w = rounded(w), objective = rounded(total), residual = rounded(inside.residual), picture = stem .. ".png",
  }, keys))
  return
end

show(navigator)
print(("after %.1f s: %s%s"):format(sim.time, status, reason ~= "" and ", " .. reason or ""))
if status ~= "driving" then print("          no map was made in that cycle: this is the one before") end
print(("target    %.2f m away%s; the straight way is %s"):format(inside.target,
  inside.escaping and " (temporary: it is escaping from a trap)" or "",
  blocked and ("obstructed from %.2f m on"):format(blocked) or "free"))
print(("memory    %d points, %d of them on the map"):format(#inside.memory, #inside.points))
if seen then
  local straight = blocked and "at first towards the target, round what is in the way later" or "straight to the target"
  print(("direction %s: there the activation around the robot is highest"):format(
    aside(bearing(seen.sector), "the %s of the target", straight)))
  print(("subgoal   %.2f m away: %s"):format(seen_distance,
    seen.exact and "the target itself" or "the highest activation along the straight ray in that direction"))
  print(("turn      the robot faces %s; the subgoal is %s: %s"):format(aside(facing, "the %s of the target", "the target"),
    aside(seen_at, "its %s", "ahead of it"), turning(w, seen_at)))
  print(("command   v = %.2f m/s, w = %.2f rad/s, the least objective of all it can reach within a period:"):format(v, w))
  print(("          J = %.3f = distance %.3f + heading %.3f + too near %.3f + slow zone %.3f + speed there %.3f"):format(
    total, cost.distance, cost.heading, cost.hard, cost.soft, cost.speed))
  local why = decisive(cost)
  print("          " .. (why and "beside the distance left, most of it is for " .. why or "nothing but the distance left costs"))
else
  print("direction none: no activation reaches the robot, it turns on the spot and looks")
  print(("command   v = %.2f m/s, w = %.2f rad/s"):format(v, w))
end
print(("picture: %s.svg .png, the world around it: %s_world.svg"):format(stem, stem))

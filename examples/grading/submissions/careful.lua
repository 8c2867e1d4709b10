-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A good submission: of the sixteen directions of the sonars the one that is open and leads to the subgoal.

-- Bearing of a point, seen from a pose, in (-pi, pi].
local function bearing(pose, point)
  local angle = math.atan(point.y - pose.y, point.x - pose.x) - pose.heading
  return math.atan(math.sin(angle), math.cos(angle))
end

-- The nearest echo in the direction of sonar i and its two neighbours.
local function open_way(ranges, i)
  local n = #ranges
  return math.min(ranges[(i - 2) % n + 1], ranges[i], ranges[i % n + 1])
end

return function(observation, subgoal)
  local ranges, wish = observation.sonar, bearing(observation.pose, subgoal)
  local heading, least = 0, math.huge
  for i = 1, #ranges do
    local direction = 2 * math.pi * (i - 1) / #ranges
    if direction > math.pi then direction = direction - 2 * math.pi end
    local detour = math.abs(math.atan(math.sin(direction - wish), math.cos(direction - wish)))
    local cost = detour + 0.3 * math.abs(direction) + 2.0 * math.max(0, 0.7 - open_way(ranges, i)) / 0.35
    if cost < least then heading, least = direction, cost end
  end
  if math.abs(wish - heading) < deg(15) and open_way(ranges, 1) > 0.6 then heading = wish end
  local v = math.min(0.5, 0.6 * (open_way(ranges, 1) - 0.15)) * math.max(0, math.cos(1.5 * heading))
  return math.max(0, v), 1.2 * heading
end

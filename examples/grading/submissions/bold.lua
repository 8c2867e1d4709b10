-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A submission that looks at nothing but the goal, and touches what stands between.
return function(observation, subgoal)
  local pose = observation.pose
  local angle = math.atan(subgoal.y - pose.y, subgoal.x - pose.x) - pose.heading
  angle = math.atan(math.sin(angle), math.cos(angle))
  return 0.5 * math.max(0, math.cos(angle)), angle
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A map of a robot that goes away and comes back.
it("a place that comes back into the window is what the global map knows of it", function()
  local world = meander.world.new { bounds = { { 0, 0 }, { 20, 8 } } }
  world:add_disc { center = { 3, 2 }, radius = 0.3 }
  local function seen_from(pose) return meander.sim.new { world = world, sonar = "ideal", start = pose }.observation end
  local map = meander.mapping.map { model = "elfes" }
  for _ = 1, 3 do map:update(seen_from { 2, 2, 0 }) end
  local known = map:probability(2.7, 2)
  expect(known > 0.6):is_true()
  map:update(seen_from { 14, 4, 0 })
  expect(map:probability(2.7, 2)):near(known, 1e-6)
  map:update(seen_from { 3, 3.4, math.pi / 2 }) -- the place is in the window again, beside the cones that look away
  expect(map:probability(2.7, 2) > 0.5):is_true()
end)

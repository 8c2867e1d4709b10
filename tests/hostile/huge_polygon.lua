-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A polygon with a million corners.
-- exit: 1
-- error: used up$|not enough memory|sandbox
local corners = {}
for i = 1, 1e6 do corners[i] = { 5 + 4 * math.cos(i / 1e6 * 6.283), 5 + 4 * math.sin(i / 1e6 * 6.283) } end
local world = meander.world.new {}
while true do
  local _, problem = pcall(world.add_polygon, world, { outer = corners })
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Keeps native objects that Lua's own count does not see.
-- sanitizer: no
-- exit: 1
-- error: not enough memory
local corners, kept = {}, {}
for i = 1, 500 do
  local a = i / 500 * 2 * math.pi
  corners[i] = { 5 + 4 * math.cos(a), 5 + 4 * math.sin(a) }
end
while true do
  local world = meander.world.new {}
  world:add_polygon { outer = corners }
  kept[#kept + 1] = world
end

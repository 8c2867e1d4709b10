-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Drops what it makes: that is allowed for as long as it likes.
-- sanitizer: no
-- exit: 0
-- output: ^done$
local corners = {}
for i = 1, 500 do
  local a = i / 500 * 2 * math.pi
  corners[i] = { 5 + 4 * math.cos(a), 5 + 4 * math.sin(a) }
end
for _ = 1, 200 do
  local world = meander.world.new {}
  world:add_polygon { outer = corners }
end
local s
for i = 1, 300 do s = ("x"):rep(1e6) .. i end
print "done"

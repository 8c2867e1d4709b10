-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- One native object that grows, and little else.
-- exit: 1
-- error: not enough memory|used up
local world = meander.world.new { bounds = { { 0, 0 }, { 1e5, 1e5 } } }
local i = 0
while true do
  i = i + 1
  world:add_disc { center = { i % 1000 * 10 + 5, i // 1000 * 10 + 5 }, radius = 0.1 }
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A drive without an end.
-- exit: 1
-- error: used up(\s|$)
local world = meander.world.new { start = { 1, 1, 0 } }
local sim = meander.sim.new { world = world }
sim:drive { navigator = function() return 0, 0 end, subgoals = { { 9, 9 } }, time_limit = 1e9 }
while true do sim:step(0, 0.1) end

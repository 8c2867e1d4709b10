-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A picture of a world with more cells than there is memory.
-- exit: 0
-- output: alive$
local world = meander.world.new { bounds = { { 0, 0 }, { 1e4, 1e4 } } }
for _, size in ipairs { 0.001, 0.002, 1e-9, 1e-300, 0, -1 } do assert(not pcall(world.export_ros, world, "a.yaml", { resolution = size })) end
local far = meander.world.new { bounds = { { -1e6, -1e6 }, { 1e6, 1e6 } } }
pcall(far.export_ros, far, "b.yaml", { resolution = 1 })
pcall(far.save, far, "b.png")
pcall(far.save, far, "b.svg")
pcall(show, far)
print "alive"

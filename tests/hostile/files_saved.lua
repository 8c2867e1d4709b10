-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Fills the disk by saving pictures.
-- exit: 1
-- error: sandbox: more than 8 MiB written|computing time
-- options: --sandbox-output 8
local world = meander.world.new { bounds = { { 0, 0 }, { 100, 100 } } }
for i = 1, 300 do world:add_box { center = { i % 17 * 5 + 5, i // 17 * 5 + 5 }, size = { 0.5, 0.5 } } end
for i = 1, 1e6 do world:save("w" .. i .. ".toml") end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Trials that start trials that start trials.
-- exit: 0
-- output: cannot run trials of its own
local function bomb() return meander.study.trials { count = 100, jobs = 100, trial = bomb } end
local results = meander.study.trials { count = 4, jobs = 1000, trial = bomb }
for _, result in ipairs(results) do print(result.ok, result.error) end

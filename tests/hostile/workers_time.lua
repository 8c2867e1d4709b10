-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Workers compute at the same time what one alone may not.
-- exit: 1
-- options: --sandbox-instructions 1000000000000
-- error: computing time of 2 s used up
local results = meander.study.trials { count = 64, jobs = 16, trial = function() for i = 1, 1e18 do local _ = ("x"):rep(10) end end }
while true do end

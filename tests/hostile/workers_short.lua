-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Workers that end before they are counted.
-- exit: 1
-- error: used up
while true do meander.study.trials { count = 1000, trial = function() for _ = 1, 1e6 do end return 1 end } end

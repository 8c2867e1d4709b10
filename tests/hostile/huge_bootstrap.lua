-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: computing time of 2 s used up$|not enough memory
local sample = {}
for i = 1, 1e5 do sample[i] = i end
meander.study.bootstrap_mean(sample, { resamples = 1e7 })

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Numbers without measure for study.
-- exit: 0
-- output: ^alive$
local huge = { 1e15, 1e9, 2 ^ 31, math.maxinteger, 1e308, 1e-308, -1, 0 / 0 }
for _, n in ipairs(huge) do
  pcall(meander.study.trials, { count = n, trial = error })
  pcall(meander.study.trials, { count = 1, jobs = n, trial = function() end })
  pcall(meander.study.wilson, n, n)
  pcall(meander.study.wilson, 1, n, n)
  pcall(meander.study.bootstrap_mean, { 1, 2 }, { confidence = n })
end
print "alive"

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Workers take together what one alone may not.
-- sanitizer: no
-- exit: 0
-- output: ^not enough memory$
local results = meander.study.trials { count = 8, jobs = 8, trial = function()
  local kept = {}
  while true do kept[#kept + 1] = ("x"):rep(10000) .. #kept end
end }
for _, result in ipairs(results) do assert(not result.ok and result.error:find "not enough memory", result.error) end
print "not enough memory"

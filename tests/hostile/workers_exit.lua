-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A worker that leaves, and one that is stopped, are failed trials and no more.
-- exit: 0
-- output: ^false\s+false\s+true
local results = meander.study.trials { count = 3, trial = function(_, i)
  if i == 1 then os.exit(0) end
  if i == 2 then error(setmetatable({}, { __tostring = function() error "again" end })) end
  return 1
end }
print(results[1].ok, results[2].ok, results[3].ok)

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: not enough memory
local kept = {}
while true do
  kept[#kept + 1] = coroutine.create(function() coroutine.yield() end)
  coroutine.resume(kept[#kept])
end

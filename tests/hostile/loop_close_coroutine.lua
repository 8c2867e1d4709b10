-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- To-be-closed variables of a coroutine that is closed, or has failed.
-- exit: 1
-- error: sandbox: 1000000 Lua instructions used up
-- options: --sandbox-instructions 1000000
local forever = setmetatable({}, { __close = function() while true do end end })
local failed = coroutine.wrap(function()
  local x <close> = forever
  error "failed"
end)
pcall(failed)
local suspended = coroutine.create(function()
  local x <close> = forever
  coroutine.yield()
end)
coroutine.resume(suspended)
coroutine.close(suspended)
print "went on"

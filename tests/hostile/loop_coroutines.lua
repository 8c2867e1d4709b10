-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Each coroutine has a counter of its own: none of these ever reaches the end of it.
-- exit: 1
-- error: sandbox: 1000000 Lua instructions used up
-- options: --sandbox-instructions 1000000
while true do
  local co = coroutine.wrap(function()
    for _ = 1, 50 do end
    coroutine.yield()
  end)
  co()
end

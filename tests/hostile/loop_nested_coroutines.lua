-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: sandbox: 1000000 Lua instructions used up
-- options: --sandbox-instructions 1000000
local function nest(depth)
  if depth == 150 then while true do end end
  while true do
    local co = coroutine.create(nest)
    pcall(coroutine.resume, co, depth + 1)
    pcall(coroutine.close, co)
  end
end
nest(1)

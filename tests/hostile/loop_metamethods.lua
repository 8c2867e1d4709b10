-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Endless work in every metamethod.
-- exit: 1
-- error: sandbox: 10000000 Lua instructions used up
-- options: --sandbox-instructions 10000000
local function forever() while true do end end
local trap = setmetatable({}, { __index = forever, __newindex = forever, __call = forever, __add = forever, __concat = forever,
  __len = forever, __eq = forever, __lt = forever, __le = forever, __unm = forever, __close = forever, __tostring = forever,
  __pairs = forever, __name = "trap" })
for _, use in ipairs {
  function() return trap.x end, function() trap.x = 1 end, function() trap() end, function() return trap + 1 end,
  function() local x <close> = trap error(trap) end, function() print(trap) end,
} do pcall(use) end
error(trap)

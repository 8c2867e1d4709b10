-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Takes every error for its own and goes on.
-- exit: 1
-- error: sandbox: 1000000 Lua instructions used up
-- options: --sandbox-instructions 1000000
local function forever() while true do end end
while true do
  pcall(pcall, forever)
  pcall(error)
  xpcall(forever, function() while true do end end)
  pcall(coroutine.wrap(forever))
  print "went on"
end

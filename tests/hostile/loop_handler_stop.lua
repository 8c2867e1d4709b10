-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A message handler that waits for the stop.
-- exit: 1
-- error: sandbox: 1000000 Lua instructions used up
-- options: --sandbox-instructions 1000000
xpcall(function() while true do end end, function() while true do end end)

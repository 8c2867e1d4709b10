-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A message handler that never ends, for an error of its own and for that of the sandbox.
-- exit: 1
-- error: used up
xpcall(error, function() while true do end end)

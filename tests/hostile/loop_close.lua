-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- To-be-closed variables run when the script is stopped, and go on for ever.
-- exit: 1
-- error: sandbox: 1000000 Lua instructions used up
-- options: --sandbox-instructions 1000000
local function forever() while true do end end
local a <close> = setmetatable({}, { __close = forever })
local b <close> = setmetatable({}, { __close = function() pcall(forever) forever() end })
forever()

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Finalizers run where nothing counts.
-- exit: 1
-- error: no finalizers
local meta = {}
setmetatable({}, meta)
meta.__gc = function() while true do end end
collectgarbage()
setmetatable({}, { __gc = function() while true do end end })

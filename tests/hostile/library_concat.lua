-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: used up
table.concat(setmetatable({}, { __index = function() return "" end }), "", 1, math.maxinteger)

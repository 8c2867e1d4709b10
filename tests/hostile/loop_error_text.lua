-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The text of the error value never ends.
-- exit: 1
-- error: used up
error(setmetatable({}, { __tostring = function() while true do end end }))

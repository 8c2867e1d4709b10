-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: computing time of 2 s used up in one call
table.move({}, 1, math.maxinteger - 1, 2, {})

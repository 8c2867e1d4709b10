-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- One call into Lua's C library that takes longer than the universe.
-- exit: 1
-- error: computing time of 2 s used up in one call
print(("a"):rep(40):find((".-"):rep(30) .. "b"))

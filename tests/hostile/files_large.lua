-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Fills the disk with one file: by writing, and by a hole.
-- exit: 1
-- error: sandbox: more than 8 MiB written
-- options: --sandbox-output 8
local file = assert(io.open("large", "w"))
file:seek("set", 1 << 40)
file:write "x"
file:flush()
for _ = 1, 1e6 do file:write(("x"):rep(65536)) end

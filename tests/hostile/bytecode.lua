-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Compiled Lua by every door.
-- exit: 0
-- output: ^refused$
local code = "\27Lua\x54\0\x19\x93\r\n\x1a\n\x04\x08\x08"
local file <close> = assert(io.open("code.lua", "wb"))
file:write(code)
file:flush()
assert(not load(code))
assert(not load(code, "x", "b"))
assert(not load(code, "x", "bt", {}))
assert(not load(function() local c = code code = nil return c end, "x", "b"))
assert(not loadfile("code.lua", "b"))
assert(not pcall(dofile, "code.lua"))
assert(not pcall(require, "code"))
assert(not rawget(string, "dump") and not pcall(function() return ("").dump end))
print "refused"

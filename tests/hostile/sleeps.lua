-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Reads what never comes: a pipe of the folder, standard input, a terminal.
-- exit: 0
-- output: ^awake$
assert(not io.open "pipe")
assert(not pcall(io.lines, "pipe"))
assert(not io.open("pipe", "w"))
assert(not pcall(dofile, "pipe"))
assert(not pcall(dofile))
assert(not pcall(meander.world.open, "pipe"))
assert(not pcall(function() return io.read() end))
print "awake"

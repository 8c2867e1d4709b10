-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The prompt for everybody: a mistake or an attack ends one input, not the session.
-- exit: 0
-- prompt
-- output: alive 1(.|\n)*alive 2(.|\n)*alive 3
-- error: not enough memory(.|\n)*not in the folder(.|\n)*secret.lua. is not in the folder(.|\n)*made.lua. is not in the folder
print("alive " .. 1)
t = {} while true do t[#t + 1] = ("x"):rep(1e5) .. #t end
t = nil print("alive " .. 2)
meander.world.open "../secret.txt"
os.exit(0)
.load ../secret.lua
.save ../made.lua
.edit
print("alive " .. 3)

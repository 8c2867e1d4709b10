-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Fills two files that are open at the same time, with numbers instead of texts.
-- exit: 1
-- error: sandbox: more than 8 MiB written
-- options: --sandbox-output 8
local files = { assert(io.open("a", "w")), assert(io.open("b", "w")) }
local numbers = {}
for i = 1, 200 do numbers[i] = -1.2345678901234e-300 end
for _ = 1, 1e4 do
  for _, file in ipairs(files) do assert(file:write(table.unpack(numbers))) end
end
print "written"

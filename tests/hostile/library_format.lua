-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Formats at their limits: errors or texts, nothing else.
-- exit: 0
-- output: ^alive$
for _, format in ipairs { "%99999d", "%99.99f", "%.99f", "%a", "%q", "%s", "%-+ #0d", "%p", "%i", "%c", "%99d%n", ("%s"):rep(1000), "%" .. ("9"):rep(1000) .. "s" } do
  pcall(string.format, format, 1e308, math.mininteger, {}, "x")
end
for _, format in ipairs { "%", "%E", "%Ez", "%O", "%c", "%" .. ("c"):rep(1000), ("%c"):rep(10000) } do
  for _, time in ipairs { 0, -1, 2 ^ 31, 2 ^ 55, math.maxinteger, math.mininteger } do pcall(os.date, format, time) end
end
pcall(os.time, { year = math.maxinteger, month = 1, day = 1 })
pcall(utf8.codepoint, ("\xff"):rep(100), 1, -1, true)
pcall(utf8.char, math.maxinteger)
pcall(string.unpack, "s8", "\255\255\255\255\255\255\255\127")
pcall(string.pack, "i17", 1)
pcall(string.rep, "x", -1)
pcall(math.randomseed, 1 / 0)
pcall(math.random, math.mininteger, math.maxinteger)
pcall(select, math.mininteger, 1)
pcall(rawset, _G, 0 / 0, 1)
pcall(collectgarbage, "generational")
pcall(collectgarbage, "stop")
assert(not pcall(collectgarbage, "setpause", 1e9))
print "alive"

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Depth: in Lua, in C, in patterns, in the parser, in coroutines, in tables of tables.
-- exit: 0
-- output: alive$
local function deep(n) return 1 + deep(n + 1) end
assert(not pcall(deep, 1))
local function by_pcall() return pcall(by_pcall) end
by_pcall()
local meta = {}
meta.__index = function(t, k) return t[k + 1] end
assert(not pcall(function() return setmetatable({}, meta)[1] end))
assert(not load(("("):rep(1e5)))
assert(not load("return " .. ("{"):rep(1e5)))
assert(not load("return " .. ("not "):rep(1e6) .. "x"))
assert(not load(("do "):rep(1e5)))
assert(not load("local a = x" .. (".y"):rep(300) .. " ="))
assert(not pcall(string.find, ("x"):rep(1e6), ("(x"):rep(500)))
assert(not pcall(string.match, ("("):rep(1e6), ("(.)"):rep(40)))
local function wrapped() return coroutine.wrap(wrapped)() end
assert(not pcall(wrapped))
local nest = {}
for _ = 1, 1e5 do nest = { nest } end
pcall(meander.world.new, nest)
pcall(meander.matrix, nest)
pcall(meander.world.from_toml, "a = " .. ("["):rep(1e6))
pcall(meander.world.from_toml, ("[a."):rep(1e5))
pcall(meander.world.from_toml, ("a."):rep(2e5) .. "b = 1")
pcall(meander.world.from_toml, "x = { y = " .. ([["""a"""""]]) .. ", " .. ("a."):rep(2e5) .. "b = 1 }")
pcall(show, nest)
pcall(print, nest)
print(select("#", table.unpack({}, 1, 100)) == 100 and "alive")

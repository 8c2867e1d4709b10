-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What others rely on cannot be changed.
-- exit: 0
-- output: ^locked$
assert(getmetatable("") == "locked")
assert(not pcall(setmetatable, _G, nil))
assert(type(getmetatable(_G)) == "string")
assert(getmetatable(io.stdout) == "locked")
for _, object in ipairs { meander.world.new {}, meander.matrix { { 1 } }, meander.polar.potential_field {} } do
  assert(type(getmetatable(object)) ~= "table")
  assert(not pcall(setmetatable, object, {}))
  assert(not pcall(rawset, object, 1, 1))
end
assert(not io.stdout.setvbuf)
for _, library in ipairs { string, os, io, debug } do
  assert(getmetatable(library) == "locked" and not pcall(setmetatable, library, {}))
end
for _, name in ipairs { "getregistry", "getupvalue", "setupvalue", "upvalueid", "upvaluejoin", "getlocal", "setlocal", "sethook", "gethook",
  "setmetatable", "getmetatable", "getuservalue", "setuservalue", "debug", "setcstacklimit" } do
  assert(rawget(debug, name) == nil and not pcall(function() return debug[name] end), name)
end
assert(not pcall(debug.getinfo, 1))
assert(not pcall(debug.getinfo, 1, "f"))
print "locked"

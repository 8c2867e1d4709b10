-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- One text that is larger than everything, in every way there is to make one; the script lives on.
-- exit: 0
-- output: ^alive$
local big = ("x"):rep(2 ^ 20)
for _, make in ipairs {
  function() return ("x"):rep(1e9) end, function() return ("x"):rep(1 << 40) end, function() return ("ab"):rep(1e18, ",") end,
  function() local s = big while true do s = s .. s end end, function() local t = {} for i = 1, 1000 do t[i] = big end return table.concat(t) end,
  function() return (("x"):rep(1000)):gsub("x", big) end, function() return string.format(("%s"):rep(200), table.unpack(setmetatable({}, { __index = function() return big end }), 1, 200)) end,
  function() return table.pack(table.unpack({}, 1, 1e7)) end, function() return table.unpack({}, 1, 1e9) end,
  function() return ("x"):rep(1e6):byte(1, -1) end, function() return string.pack("!16" .. ("d"):rep(1e7)) end,
  function() return load(function() return big end) end, function() return utf8.char(table.unpack({}, 1, 1e6)) end,
} do
  local done, problem = pcall(make)
  assert(not done or type(problem) ~= "string" or #problem < 2 ^ 27, "too large")
end
print "alive"

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A submission that would rather have the points than drive. None of this works: what is not
-- refused changes only what this file sees itself.
local attempts = {
  function() os.exit(0) end,
  function() io.open("grades.csv", "w"):write("everything") end,
  function() os.execute "rm -rf ." end,
  function() expect = function() return setmetatable({}, { __index = function() return function() end end }) end end,
  function() require("meander.testing").expect = nil end,
  function() debug.sethook() end,
  function() getmetatable("").__index.format = nil end,
  function() load("\27Lua") end,
  function() meander.world.open("worlds/clutter.toml"):remove "*" end,
  function() print("8 passed, 0 failed") end,
}

local refused = 0
for _, attempt in ipairs(attempts) do refused = refused + (pcall(attempt) and 0 or 1) end
print(("%d of %d attempts refused"):format(refused, #attempts))

return function() return 0.5, 0 end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- What the limits of a sandbox cost: run it with and without --sandbox. The best of five, in milliseconds.
local function time(name, work)
  local best = math.huge
  for _ = 1, 5 do
    local start = os.clock()
    work()
    best = math.min(best, os.clock() - start)
  end
  print(("%-32s %6.0f ms"):format(name, 1e3 * best))
end

local world = meander.world.new { start = { 1, 1, 0 } }

time("30 million empty rounds", function() for _ = 1, 3e7 do end end)
time("5 million rounds of arithmetic", function()
  local sum = 0
  for i = 1, 5e6 do sum = sum + i % 7 * 2 end
end)
time("5 million calls of Lua", function()
  local function next_of(x) return x + 1 end
  local x = 0
  for _ = 1, 5e6 do x = next_of(x) end
end)
time("1 million tables", function()
  local list = {}
  for i = 1, 1e6 do list[i] = { i } end
end)
time("2 million reads of world.title", function() for _ = 1, 2e6 do local _ = world.title end end)
time("20,000 steps of a simulation", function()
  local sim = meander.sim.new { world = world, seed = 1 }
  for _ = 1, 20000 do sim:step(0.1, 0.1) end
end)

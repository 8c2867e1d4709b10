-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The same seed gives the same bits, whatever was done before and however many processes work.
local function office(seed) return meander.sim.new { world = meander.world.open "worlds/office.toml", seed = seed } end

local function drive(seed) return office(seed):drive { navigator = "potential_field", subgoals = { "door_a", "hall" } } end

describe("the same seed", function()
  it("repeats a drive", function()
    expect(function() return drive(3) end):repeats()
    expect(drive(3)):never():repeats(drive(4))
  end)

  it("repeats a simulation after reset", function()
    local sim = office(5)
    local first = sim:fork()
    for _ = 1, 20 do sim:step(0.3, 0.1) end
    expect(sim):never():repeats(first)
    sim:reset(5)
    expect(sim):repeats(first)
  end)

  it("lets a fork go the same way", function()
    local sim = office(5)
    for _ = 1, 10 do sim:step(0.3, 0.1) end
    local fork = sim:fork()
    for _ = 1, 10 do
      sim:step(0.2, -0.1)
      fork:step(0.2, -0.1)
    end
    expect(sim):repeats(fork)
  end)

  it("gives the same trials on one core and on two", function()
    local function trials(jobs)
      return meander.study.trials { count = 4, seed = 2, jobs = jobs, trial = function(seed) return { hash = drive(seed).hash } end }
    end
    expect(trials(1)):equals(trials(2))
  end)

  it("starts every test from the same random numbers", function(seed)
    math.randomseed(seed)
    local wanted = math.random(1 << 30)
    math.randomseed(seed)
    expect(math.random(1 << 30)):equals(wanted)
  end)
end)

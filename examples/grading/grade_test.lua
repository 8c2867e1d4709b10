-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Grades a navigator: meander test examples/grading -- my_navigator.lua
-- What is asked for stands in README.md beside this file.
local load_submission = require "loader"

local folder = arg[0]:match("^(.*/)") or ""
local path = arg[1] or folder .. "submissions/careful.lua"

-- Loaded before each test, so that a file that cannot be is told in one line; a second drive loads it anew.
local loaded
local function submission()
  local navigator = loaded or load_submission(path)
  loaded = nil
  return navigator
end

-- One drive to the places of a shipped world, with the real sonar's noise, by a navigator that remembers nothing.
local function drive(world, seed, subgoals)
  local sim = meander.sim.new { world = meander.world.open("worlds/" .. world .. ".toml"), robot = "nomad200", seed = seed }
  return sim:drive { navigator = submission(), subgoals = subgoals, time_limit = 120 }
end

describe("the navigator", function()
  before_each(function()
    local done, result = pcall(load_submission, path)
    if not done then error(result, 0) end
    loaded = result
  end)

  it("gives a speed and a turning rate", { points = 1 }, function()
    local sim = meander.sim.new { world = meander.world.open "worlds/clutter.toml" }
    local v, w = submission()(sim.observation, { x = 3, y = 3 })
    expect(v):is_a "number":between(-1, 1)
    expect(w):is_a "number":between(-2, 2)
  end)

  for seed = 1, 3 do
    it(("crosses the clutter with seed %d"):format(seed), { points = 2 }, function()
      expect(drive("clutter", seed, { "goal" })):reaches("goal"):within(90):touches_nothing()
    end)
  end

  it("passes the doors of the office", { points = 2 }, function()
    expect(drive("office", 1, { "door_a", "hall" })):reaches("hall"):within(90):touches_nothing()
  end)

  it("keeps 5 cm from everything", { points = 1 }, function()
    expect(drive("clutter", 4, { "goal" })):reaches("goal"):keeps(0.05)
  end)

  it("does not dawdle", { points = 1 }, function()
    expect(drive("clutter", 5, { "goal" })):reaches("goal"):shorter_than(20)
  end)

  it("does the same twice", { points = 1 }, function()
    expect(function() return drive("clutter", 6, { "goal" }) end):repeats()
  end)
end)

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Drives through the shipped worlds, judged by the truth.
local function drive(world, options)
  local sim = meander.sim.new { world = meander.world.open("worlds/" .. world .. ".toml"), seed = options.seed or 7 }
  options.seed = nil
  options.navigator = options.navigator or "potential_field"
  return sim:drive(options)
end

describe("a drive through the office", function()
  it("reaches its subgoals without a contact", function()
    expect(drive("office", { subgoals = { "door_a", "hall" } }))
      :reaches("door_a"):within(30):reaches("hall"):within(60):reaches():touches_nothing():keeps(0.05):shorter_than(12)
  end)

  it("stops at the time limit and says so", function()
    local run = drive("office", { subgoals = { "hall" }, time_limit = 2 })
    expect(run):ends_because("time limit"):within(2.4):never():reaches("hall")
    expect(run.success):is_false()
  end)

  it("may be ended by whoever watches", function()
    local steps = 0
    local run = drive("office", { subgoals = { "hall" }, on_step = function()
      steps = steps + 1
      return steps < 5
    end })
    expect(run.cycles):equals(5)
    expect(run):ends_because "on_step"
  end)

  it("touches a crate that falls in its way", function()
    local run = drive("office", { subgoals = { "hall" }, stop_on_contact = true, time_limit = 20,
      navigator = function() return 0.5, 0 end })
    expect(run):never():touches_nothing():ends_because "contact"
    expect(run.clearance_min):near(0, 0.02)
  end)
end)

describe("a navigator written in Lua", function()
  it("sees sixteen sonars and the way to go", function()
    local seen
    drive("clutter", { subgoals = { "goal" }, time_limit = 1, navigator = function(observation, subgoal)
      seen = { sonars = #observation.sonar, name = subgoal.name }
      return 0, 0
    end })
    expect(seen):equals { sonars = 16, name = "goal" }
  end)

  it("fails the drive with its own error", function()
    local function broken() error "no idea" end
    expect(function() drive("clutter", { subgoals = { "goal" }, navigator = broken }) end):throws "no idea"
  end)
end)

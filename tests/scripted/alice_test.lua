-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- ALICE: any direction, whiskers, light, and what its maps do besides learning.
local function alice(drift)
  local world = meander.world.new { bounds = { { 0, 0 }, { 6, 6 } }, start = { 3, 3, 0 } }
  world:add_wall { points = { { 3.2, 0 }, { 3.2, 6 } } }
  world:add_light { position = { 1, 3 } }
  return meander.sim.new { world = world, robot = "alice", drift = drift, whisker = { false_alarm = 0, miss = 0 } }
end

describe("ALICE", function()
  it("goes sideways and says so", function()
    local sim = alice()
    for _ = 1, 10 do sim:step { v = -0.05, vy = 0.2, w = 0 } end
    expect(sim.state.vy):near(0.2, 1e-9)
    expect(sim.observation.vy):near(0.2, 1e-9)
    expect(sim.state.pose[2] > 3.3):is_true()
  end)

  it("feels the wall at its side and sees the lamp behind", function()
    local sim = alice()
    local whisker, light = sim.observation.whisker, sim.observation.light
    expect(whisker[1]):equals(1)
    expect(whisker[13]):equals(0)
    expect(light[13] > light[1]):is_true()
  end)

  it("stays localised without learning", function()
    local sim, map = alice(), meander.topology.map {}
    for _ = 1, 60 do
      map:step(sim.observation)
      sim:step { v = -0.2, vy = 0, w = 0 }
    end
    local places = #map
    for _ = 1, 20 do
      map:follow(sim.observation)
      sim:step { v = 0.2, vy = 0, w = 0 }
    end
    expect(#map):equals(places)
    expect(map.samples):equals(80)
  end)

  it("exports the minimal model as C", function()
    local sim, map = alice(), meander.topology.map {}
    local minimal = meander.topology.minimal { map = map }
    for _ = 1, 60 do
      map:step(sim.observation)
      minimal:step(map)
      sim:step { v = -0.2, vy = 0, w = 0 }
    end
    local path = os.tmpname()
    minimal:save_c(path, "corridor")
    local file <close> = assert(io.open(path))
    expect(file:read "a":find("static const uint8_t corridor_places", 1, true) ~= nil):is_true()
    os.remove(path)
  end)

  it("chooses goals of known places, and moments of the last samples", function()
    local studies = require "meander.alice"
    local robot = { map = { places = { { number = 3 }, { number = 7 } } }, scores = {} }
    function robot.scores:true_place(_, number) return number == 7 and { x = 0, y = 0 } or nil end
    for _ = 1, 10 do expect(studies.goal(robot)):equals(7) end
    function robot.scores:true_place() return nil end
    expect(function() studies.goal(robot) end):throws "no place of the map has a true place"
    expect(studies.first_moment { samples = 5000, goals = 20 }):equals(4050)
    expect(studies.first_moment { samples = 100, goals = 20 }):equals(50)
    expect(studies.first_moment { samples = 100, goals = 0 }):equals(101)
  end)
end)

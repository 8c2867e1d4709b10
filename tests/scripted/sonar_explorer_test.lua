-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Explorers that see by sonar alone, judged by the truth.
local course = require "meander.labyrinth_course"

describe("an explorer in a small labyrinth", function()
  for _, strategy in ipairs { "indicators", "dstar_lite", "frontier", "goal_frontier" } do
    it("reaches its goal and is there: " .. strategy, function()
      local cells = meander.indicator.labyrinth { size = 4, loops = 0.1, seed = 5 }
      local e = meander.indicator.sonar_explorer(course.explorer { goal = cells.goal, strategy = strategy })
      local _, sim = course.run { world = cells:world(), explorer = e, seed = 1, limit = 1500 }
      local pose = sim.robots[1].pose
      expect(e.ending):is("reached")
      expect(math.abs(pose.x - cells.goal.x) < 0.3 and math.abs(pose.y - cells.goal.y) < 0.3):is_true()
      expect(e:known(cells.goal)):is("free")
      expect(e:known { -50, 0 }):is("unknown")
    end)
  end

  it("knows from run to run what it knows, and gives the same run for the same seed", function()
    local cells = meander.indicator.labyrinth { size = 4, loops = 0.1, seed = 6 }
    local placed, decided = 0, 0
    local function both()
      local e = meander.indicator.sonar_explorer(course.explorer {
        goal = cells.goal, on_indicator = function() placed = placed + 1 end, on_decision = function() decided = decided + 1 end,
      })
      course.run { world = cells:world(), explorer = e, seed = 1 }
      local first = #e:graph()
      course.run { world = cells:world(), explorer = e, seed = 2 }
      expect(e.ending):is("reached")
      expect(#e:graph() >= first and e:route() > 0 and e.blocked >= 0):is_true()
      return e.walked, e.decisions, e.second_looks, e.reason, e.proven
    end
    local a, b = table.pack(both()), table.pack(both())
    for i = 1, 5 do expect(a[i]):is(b[i]) end
    expect(placed > 0 and decided == 2 * a[2]):is_true()
  end)

  it("is not driven by the functions that it calls, nor by two robots, and goes on after an error of theirs", function()
    local cells = meander.indicator.labyrinth { size = 3, loops = 0.2, seed = 4 }
    local what, e = "drive"
    e = meander.indicator.sonar_explorer(course.explorer {
      goal = cells.goal,
      on_decision = function(decision)
        if what == "drive" then course.run { world = cells:world(), explorer = e, seed = 1 } end
        if what == "fail" and decision.decisions == 1 then error("mine", 0) end
        if what == "yield" then coroutine.yield() end
        local file = os.tmpname()
        e:save(file)
        expect(#meander.indicator.open_sonar_explorer(file):graph()):is(#e:graph())
      end,
    })
    local function go() return course.run { world = cells:world(), explorer = e, seed = 1 } end
    expect(go):throws "explorer is at work"
    what = "fail"
    expect(go):throws "mine"
    what = "yield"
    expect((coroutine.wrap(function() return pcall(go) end)())):is(false)
    what = "look"
    go()
    expect(e.ending):is("reached")
    local both = { navigator = "polar", guide = e:guide() }
    local sim = meander.sim.new { world = cells:world(), robots = { {}, { start = { 1.5, 0.5, 0 } } } }
    expect(function() sim:drive { pilots = { both, { navigator = "polar", guide = e:guide() } } } end):throws "explorer is at work"
  end)

  it("knows a route to the goal that it has reached, in every run", function()
    local function check(world, goal)
      local e = meander.indicator.sonar_explorer(course.explorer { goal = goal })
      for run = 1, 2 do
        course.run { world = world, explorer = e, seed = run }
        expect(e.ending):is("reached")
        expect((e:route() or 0) > 0):is_true()
      end
    end
    local office = meander.world.open "worlds/office.toml"
    for _, goal in ipairs { { 8, 4.5 }, { 6, 4.5 }, { 4, 4.5 }, { 1.4, 6.8 }, { 11.4, 2.9 }, { 5, 5 } } do check(office, goal) end
    for seed = 1, 4 do
      local cells = meander.indicator.labyrinth { size = 5, loops = 0.1, seed = seed }
      check(cells:world(), cells.goal)
    end
  end)

  it("says so when the goal is walled in", function()
    local cells = meander.indicator.labyrinth { size = 3, loops = 0.2, seed = 2 }
    cells:set_open(3, 3, "west", false)
    cells:set_open(3, 3, "south", false)
    local e = meander.indicator.sonar_explorer(course.explorer { goal = cells.goal })
    course.run { world = cells:world(), explorer = e, seed = 1 }
    expect(e.ending):is("no_passable_direction")
  end)
end)

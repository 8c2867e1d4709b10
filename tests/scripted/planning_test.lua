-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Global planning as scripts see it.
local function room()
  local map = meander.planning.map { world = meander.world.new { bounds = { { 0, 0 }, { 8, 4 } } }, resolution = 0.1 }
  map:block { { 3.9, 0 }, { 4.1, 3 } }
  return map
end

describe("a map of cells", function()
  it("is made of a world, and edited", function()
    local map = room()
    expect(map.width):equals(80)
    expect(map.height):equals(40)
    expect(map.resolution):equals(0.1)
    expect(map:solid(4, 1)):is_true()
    map:block({ { 3.9, 0 }, { 4.1, 1 } }, false)
    expect(map:solid(4, 0.5)):is_false()
    expect(map:solid(4, 2)):is_true()
    expect(map:solid(-1, 2)):is_true()
  end)

  it("is read from a file of movingai.com with its scenarios", function()
    local name = os.tmpname()
    local file = io.open(name, "w")
    file:write "type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n"
    file:close()
    local map = meander.planning.read_map(name)
    expect(map:solid(1.5, 1.5)):is_true()
    file = io.open(name, "w")
    file:write "version 1\n0 x.map 3 2 0 0 2 0 4\n"
    file:close()
    local task = map:scenarios(name)[1]
    os.remove(name)
    local plan = meander.planning.plan { map = map, start = task.start, target = task.goal, planner = "astar" }
    expect(plan.measures.length):equals(task.length)
  end)
end)

describe("a plan", function()
  it("of every planner leads to the target and keeps clear", function()
    for _, planner in ipairs(meander.planning.planners()) do
      local plan = meander.planning.plan {
        map = room(), start = { 1, 1 }, target = { 7, 1 }, robot_radius = 0.25, planner = planner,
      }
      expect(plan.planner):equals(planner)
      expect(plan.clear):is_true()
      expect(plan.measures.clearance_min >= 0.25):is_true()
      expect(math.abs(plan.path[#plan.path].x - 7.05) < 1e-9):is_true()
      expect(plan.statistics.dead_units):equals(0)
    end
  end)

  it("has a landscape that rises to the target, and other paths on it", function()
    local plan = meander.planning.plan { map = room(), targets = { { 7, 1 }, { 7, 3 } } }
    expect(plan:value(7, 1)):equals(0)
    expect(plan:value(5, 1) > plan:value(1, 1)):is_true()
    expect(plan:value(4, 1)):equals(nil)
    expect(plan:landscape().rows):equals(40)
    local smooth, steps = plan:from { 1, 1 }, plan:from({ 1, 1 }, "steepest")
    expect(smooth.measures.length < steps.measures.length):is_true()
  end)

  it("solved for its start alone is not read from another", function()
    local plan = meander.planning.plan { map = room(), start = { 6, 1 }, target = { 7, 1 }, extent = "start" }
    expect(plan.statistics.complete):is_false()
    expect(plan:from({ 6, 1 }, "steepest").path ~= nil):is_true()
    expect(function() plan:from { 1, 1 } end):throws "solved for the start of this plan alone"
  end)

  it("has no harmonic function where steps pass between corners", function()
    local options = { cells = { { 0, 1 }, { 1, 0 } }, resolution = 1, start = { 0.5, 0.5 }, target = { 1.5, 1.5 }, corners = "cut" }
    for _, planner in ipairs(meander.planning.planners()) do
      options.planner = planner
      if planner == "harmonic" then
        expect(function() meander.planning.plan(options) end):throws "corners 'keep' expected, got 'cut'"
      else
        expect(meander.planning.plan(options) ~= nil):is_true()
      end
    end
  end)

  it("says why there is none", function()
    local map = room()
    local plan, why = meander.planning.plan { map = map, start = { 4, 1 }, target = { 7, 1 } }
    expect(plan):equals(nil)
    expect(why):equals "no path: the start in cell (40, 10) at (4.05, 1.05) m lies in a wall"
    map:block { { 3.9, 0 }, { 4.1, 4 } }
    plan, why = meander.planning.plan { map = map, start = { 1, 1 }, target = { 7, 1 } }
    expect(why):equals "no path: the start in cell (10, 10) at (1.05, 1.05) m is cut off from the target in cell (70, 10) at (7.05, 1.05) m"
  end)

  it("leads from place to place of a world", function()
    local office = meander.world.open "worlds/office.toml"
    local plan = meander.planning.plan { world = office, start = "hall", target = "kitchen", robot_radius = 0.25 }
    expect(plan.clear):is_true()
    expect((pcall(meander.planning.plan, { world = office, start = "hal", target = "kitchen" }))):equals(false)
  end)

  it("answers bad input in words, whoever plans, and changes nothing", function()
    local walled, not_a_number = room(), 0 / 0
    walled:block { { 3.9, 0 }, { 4.1, 4 } }
    local cases = {
      { "option 'target': missing", { start = { 1, 1 } } },
      { "option 'target': missing", { start = { 1, 1 }, targets = {} } },
      { "the target in cell %(40, 10%) at %(4.05, 1.05%) m lies in a wall", { start = { 1, 1 }, target = { 4, 1 } } },
      { "no target can be stood on", { start = { 1, 1 }, targets = { { 4, 1 }, { 4, 2 } } } },
      { "the start in cell %(40, 10%) at %(4.05, 1.05%) m lies in a wall", { start = { 4, 1 }, target = { 1, 1 } } },
      { "lies outside of the map of 80 x 40 cells", { start = { 1, 1 }, target = { 1e300, 1 } } },
      { "is cut off from the target in cell %(70, 10%)", { start = { 1, 1 }, target = { 7, 1 } } },
      { "is nearer to a wall than the robot's radius", { start = { 1, 1 }, target = { 3.7, 1 }, robot_radius = 0.5 } },
      { "option 'target': {x, y} expected", { start = { 1, 1 }, target = { not_a_number, 1 } } },
      { "option 'robot_radius': a number from 0", { start = { 1, 1 }, target = { 3, 1 }, robot_radius = -1 } },
      { "option 'steepness': a number from 0.35 to 0.9", { start = { 1, 1 }, target = { 3, 1 }, steepness = 1.2 } },
      { "option 'resolution': a number from", { map = false, cells = { { 0 } }, resolution = 0, target = { 0, 0 } } },
      { "map: at least one cell expected, got 0 x 1", { map = false, cells = { {} }, target = { 0, 0 } } },
      { "rows of equal length expected", { map = false, cells = { { 0, 0 }, { 0 } }, target = { 0, 0 } } },
    }
    local before = meander.render.text(walled)
    for _, planner in ipairs(meander.planning.planners()) do
      for _, case in ipairs(cases) do
        local options = { map = walled, planner = planner }
        for key, value in pairs(case[2]) do options[key] = value or nil end
        if case[2].map == false then options.map = nil end
        local ok, plan, why = pcall(meander.planning.plan, options)
        expect(ok and plan):equals(ok and nil)
        expect(ok and why or plan):matches(case[1])
      end
      for _, cells in ipairs { { { 0 } }, { { 0, 0, 0 } }, { { 0 }, { 0 } } } do
        local plan = meander.planning.plan {
          cells = cells, resolution = 1, start = { 0.5, 0.5 }, target = { #cells[1] - 0.5, #cells - 0.5 }, planner = planner,
        }
        expect(plan.measures.length):equals(#cells[1] + #cells - 2)
      end
    end
    for _, hard in ipairs { not_a_number, -1, 0, 1e300 } do
      expect((pcall(walled.set_difficulty, walled, { { 0, 0 }, { 1, 1 } }, hard))):equals(false)
    end
    expect((pcall(walled.set_drag, walled, { { 0, 0 }, { 1, 1 } }, { 1, 0 }))):equals(false)
    expect(meander.render.text(walled)):equals(before)
  end)

  it("goes round what is hard and up no hill without need", function()
    local hard, steep = room(), room()
    local function lowest(map, planner)
      local plan, least = meander.planning.plan { map = map, start = { 1, 3.5 }, target = { 3.5, 3.5 }, planner = planner }, 4
      for _, p in ipairs(plan.path) do least = math.min(least, p.y) end
      return least
    end
    local even = lowest(hard)
    hard:set_difficulty({ { 1.5, 2.9 }, { 3, 4 } }, 20)
    steep:set_drag({ { 1.5, 2.9 }, { 3, 4 } }, { 0.8, 0 })
    expect(lowest(hard) < even - 0.3):is_true()
    expect(lowest(steep, "distance_transform") < even - 0.3):is_true()
  end)

  it("says which solver ran", function()
    local map = room()
    local function solver(options)
      options.map, options.start, options.target = map, { 1, 1 }, { 7, 1 }
      return meander.planning.plan(options).statistics.solver
    end
    expect(solver {}):equals "tiles"
    expect(solver { lattice = "wide" }):equals "active_list"
    expect(solver { extent = "start" }):equals "for_start"
    for _, name in ipairs { "active_list", "raster", "synchronous" } do expect(solver { solver = name }):equals(name) end
    expect(solver { planner = "harmonic" }):equals "exact"
    expect(solver { planner = "astar" }):equals ""
    map:set_difficulty({ { 1, 1 }, { 2, 2 } }, 2)
    expect(solver {}):equals "active_list"
  end)

  it("refuses what does not follow edits, or would be passed over", function()
    local function make(options)
      options.map, options.target = options.map or room(), { 7, 1 }
      return function() return meander.planning.replanner(options) end
    end
    expect(make { solver = "raster" }):throws "'tiles' or 'active_list' expected to follow edits, got 'raster'"
    expect(make { extent = "start" }):throws "unknown option 'extent'"
    expect(make { harmonic = { solver = "sor" } }):throws "unknown option 'harmonic'"
    expect(make { planner = "astar" }):throws "unknown option 'planner'"
    expect(function() meander.planning.replanner { target = { 1, 1 } } end):throws "option 'map': missing"
    expect(make { solver = "active_list", weights = "gaussian", threads = 2 }():replan().statistics.solver):equals "active_list"
  end)

  it("follows the edits of its map", function()
    local map = room()
    local replanner = meander.planning.replanner { map = map, start = { 1, 1 }, target = { 7, 1 }, robot_radius = 0.25 }
    local first = replanner:replan()
    map:block { { 3.9, 0 }, { 4.1, 4 } }
    local none, why = replanner:replan()
    expect(none):equals(nil)
    expect(why:find "is cut off" ~= nil):is_true()
    map:block({ { 3.9, 3 }, { 4.1, 4 } }, false)
    local again = replanner:replan()
    expect(again.clear):is_true()
    expect(math.abs(again.measures.length - first.measures.length) < 0.01):is_true()
    expect(replanner.relaxations > 0):is_true()
    replanner:replan() -- nothing has changed
    expect(replanner.relaxations):equals(0)
  end)
end)

describe("a planned route", function()
  it("asks at once whether its planner takes the map", function()
    local map = room()
    map:set_difficulty({ { 1, 1 }, { 2, 2 } }, 2)
    for _, planner in ipairs { "harmonic", "theta_star" } do
      local function make() meander.autonomy.planned_route { map = map, target = { 7, 1 }, planner = planner } end
      expect(make):throws "no difficulty and no drag expected"
    end
  end)

  it("takes the robot to its target", function()
    local world = meander.world.open "worlds/office.toml"
    local sim = meander.sim.new { world = world, start = { 1, 1, 0 }, seed = 7 }
    local guide = meander.autonomy.planned_route { world = world, target = { 6, 4.5 }, robot_radius = 0.27 }
    local run = sim:drive { navigator = "polar", guide = guide, time_limit = 90 }
    expect(run.success):is_true()
    expect(run):touches_nothing()
  end)
end)

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Indicators, explorers, labyrinths and the network, as scripts use them.
local indicator = meander.indicator

local function temporary(suffix)
  local name = os.tmpname()
  os.remove(name)
  return name .. suffix
end

describe("a graph of indicators", function()
  local function pair()
    local graph = indicator.graph()
    local a, b = graph:place { 0, 0 }, graph:place { 3, 0 }
    a:link(a:add_port(0, 2), b, b:add_port(math.pi), 3.2)
    return graph, a, b
  end

  it("knows where its ports lead", function()
    local graph, a, b = pair()
    expect(#graph):equals(2)
    expect(a.ports[1].state):equals("linked")
    expect(a.ports[1].to):equals(b.serial)
    expect(graph.links[1].length):equals(3.2)
    expect(graph:nearest { 2, 0 } == b):is_true()
    expect(b.position.x):equals(3)
    expect(graph.ways[1].a):equals(1)
    expect(#graph.indicators):equals(2)
  end)

  it("has no link any more once it was blocked", function()
    local graph, a, b = pair()
    a:block(1)
    expect(#graph.links):equals(0)
    expect(b.ports[1].state):equals("blocked")
    b:reopen(1)
    expect(b.ports[1].state):equals("unknown")
    b:give_up(1)
    expect(b.ports[1].state):equals("dead_end")
    a:remove()
    expect(a.alive):is_false()
    expect(function() return a.position end):throws("indicator 1 was removed")
  end)

  it("is written and read", function()
    local graph = pair()
    expect(indicator.graph_from_text(graph.source).source):equals(graph.source)
    for _, suffix in ipairs { ".dot", ".graphml", ".json", ".indicators" } do
      local path = temporary(suffix)
      graph:save(path)
      if suffix == ".indicators" then expect(indicator.open_graph(path).source):equals(graph.source) end
      os.remove(path)
    end
  end)

  it("is drawn over a world", function()
    local graph = pair()
    expect(meander.render.text(graph:over(meander.world.new {}))):contains("S")
  end)
end)

describe("an explorer", function()
  it("says which way to go and why", function()
    local placed, decided = {}, 0
    local explorer = indicator.explorer {
      goal = { 5, 0 },
      on_indicator = function(one) placed[#placed + 1] = one.serial end,
      on_decision = function() decided = decided + 1 end,
    }
    explorer:begin()
    local decision = explorer:step {
      position = { 0, 0 }, ports = { { direction = math.pi / 2, reach = 2 }, { direction = 0, reach = 2 } },
    }
    expect(decision.ending):equals("driving")
    expect(decision.direction):equals(0)
    expect(#placed):equals(1)
    decision = explorer:step { position = { 5, 0 }, ports = { { direction = math.pi } }, back = math.pi, walked = 5 }
    expect(decision.ending):equals("reached")
    expect(decided):equals(2)
    local route, length = explorer:route()
    expect(#route):equals(2)
    expect(length):equals(5)
    expect(explorer.goal.x):equals(5)
    expect(explorer.options.rules):equals("optimistic")
    expect(function() explorer:step { position = { 5, 0 } } end):throws("the run is over")
  end)

  it("goes on from its file as if nothing had been", function()
    local cells = indicator.labyrinth { size = 8, loops = 0.1, seed = 5 }
    local one = indicator.explorer { goal = cells.goal }
    cells:explore(one)
    local path = temporary ".explorer"
    one:save(path)
    local other = indicator.open_explorer(path)
    os.remove(path)
    expect(cells:explore(other).length):equals(cells:explore(one).length)
    expect(other:graph().source):equals(one:graph().source)
  end)
end)

describe("a planner over cells", function()
  it("keeps to the shortest way by what it has seen, and ends with the shortest there is", function()
    local cells = indicator.labyrinth { size = 9, loops = 0.1, seed = 3 }
    local planner = cells:planner()
    local run
    repeat run = planner:walk(cells) until planner.proven or run.ending ~= "reached"
    expect(run.length):equals(cells:shortest())
    expect(tostring(planner)):is("cell_planner: the shortest way is known")
    expect(function() planner:walk(indicator.labyrinth { size = 4 }) end):throws("9 x 9 cells expected")
    expect(cells:planner(cells.start):walk(cells).length):equals(0)
  end)
end)

describe("a labyrinth", function()
  it("is explored to the shortest route", function()
    local cells = indicator.labyrinth { kind = "prim", size = 9, loops = 0.1, seed = 3 }
    local explorer = indicator.explorer { goal = cells.goal, eps = 0 }
    repeat local run = cells:explore(explorer) until run.ending ~= "reached" or explorer.state.proven
    expect(cells:explore(explorer, cells.start).length):equals(cells:shortest())
  end)

  it("whose goal is walled in is said to have no passable direction left", function()
    local cells = indicator.labyrinth { size = 6, seed = 3 }
    for _, side in ipairs { "west", "south" } do cells:set_open(cells.columns, cells.rows, side, false) end
    expect(cells:open(6, 6, "west")):is_false()
    local run = cells:explore(indicator.explorer { goal = cells.goal })
    expect(run.ending):equals("no_passable_direction")
    expect(run.coverage):equals(1)
    expect(cells:shortest()):is_nil()
  end)

  it("is a world, too", function()
    local world = meander.world.labyrinth { size = 5, seed = 2, corridor = 1.2 }
    expect(world.bounds[2].x):equals(6)
    expect(indicator.labyrinth({ size = 5, seed = 2 }):world { corridor = 1.2, seed = 2 }):equals(world)
  end)
end)

describe("the network", function()
  local links = { { 1, 2, 3 }, { 2, 3, 1 }, { 1, 3, 5 } }
  it("finds the shortest route and shows what fired", function()
    local found = indicator.shortest_path { links = links, start = 1, goal = 3 }
    expect(found.length):equals(4)
    expect(#found.route):equals(3)
    expect(#found.candidates):equals(2)
    expect(found.rows[1][1].indicator):equals(1)
    expect(indicator.shortest_path({ links = links, start = 1, goal = 3, method = "dijkstra" }).length):equals(4)
  end)
  it("has no route where there is none, and refuses links without length", function()
    expect(indicator.shortest_path({ links = links, start = 1, goal = 4 }).route):is_nil()
    expect(function() indicator.shortest_path { links = { { 1, 2, 0 } }, start = 1, goal = 2 } end):throws("length > 0")
  end)
end)

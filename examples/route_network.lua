-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The neural network that finds the shortest route, row by row: a labyrinth is explored, its indicators are the columns,
-- and excitation spreads from the start until a row stays quiet. The last picture has the winning route in it.
--
--   ./meander examples/route_network.lua --size 12 --rate 4
--   ./meander examples/route_network.lua --size 20 --kind backtracker --seeds 100    counts what the paper's rows lose
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "shows how the network finds the shortest route",
  { "--kind NAME", default = "mixed", values = { "backtracker", "prim", "mixed" }, help = "how the labyrinth grows" },
  { "--size N", default = 9, help = "cells along each side" },
  { "--loops P", default = 0.1, help = "share of inner walls that are taken away" },
  { "--seed N", default = 1, help = "seed of the labyrinth" },
  { "--seeds N", default = 1, help = "more than 1: a count over so many whole labyrinths instead of pictures" },
  { "--rows NAME", default = "adaptive", values = { "adaptive", "paper" }, help = "how many rows the network has" },
  { "--rate N", default = 3.0, help = "rows per second on a terminal" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}
if options.size < 2 or options.size > 60 then report.usage_error("--size: 2 to 60 expected, got " .. options.size) end
if options.loops < 0 or options.loops > 1 then report.usage_error("--loops: 0 to 1 expected, got " .. options.loops) end
if options.rate < 0.1 or options.rate > 100 then report.usage_error("--rate: 0.1 to 100 expected, got " .. options.rate) end

local function labyrinth(seed)
  return meander.indicator.labyrinth { kind = options.kind, size = options.size, loops = options.loops, seed = seed }
end

-- Finds the route between two indicators of a graph.
local function finder(graph, start, goal)
  local links = {}
  for i, link in ipairs(graph.links) do links[i] = { link.a, link.b, link.length } end
  return function(method, rows)
    return meander.indicator.shortest_path { links = links, start = start, goal = goal, method = method, rows = rows }
  end
end

-- What the paper's rows lose, and how often Hopfield's form finds a route: labyrinths explored to the last corner, because
-- the goal lies outside, and routes from the start to the indicator nearest to the last cell.
local function count()
  local n, lost, longer, tried, valid, rows, indicators = 0, 0, 0, 0, 0, 0, 0
  for seed = options.seed, options.seed + options.seeds - 1 do
    local cells = labyrinth(seed)
    local explorer = meander.indicator.explorer { goal = { -9, -9 }, explorer = "nearest" }
    cells:explore(explorer)
    local graph = explorer:graph()
    local find = finder(graph, 1, graph:nearest(cells.goal).serial)
    local exact, paper = find("network", "adaptive"), find("network", "paper")
    n, indicators, rows = n + 1, indicators + #graph, math.max(rows, #exact.route - exact.paper_rows)
    lost = lost + (paper.route and 0 or 1)
    longer = longer + (paper.route and paper.length > exact.length + 1e-6 and 1 or 0)
    if #graph <= 120 then
      tried = tried + 1
      valid = valid + (find("hopfield").route and 1 or 0)
    end
  end
  local line = {
    kind = options.kind, size = options.size, loops = options.loops, n = n, indicators = indicators / n,
    paper_no_route = lost, paper_longer = longer, rows_missing = math.max(rows, 0), hopfield_tried = tried,
    hopfield_valid = valid,
  }
  local keys = {
    "kind", "size", "loops", "n", "indicators", "paper_no_route", "paper_longer", "rows_missing", "hopfield_tried",
    "hopfield_valid",
  }
  if options.json then return print(json.encode(line, keys)) end
  print(("%d %s labyrinths of %d x %d cells, loops %g, %.1f indicators"):format(
    n, line.kind, line.size, line.size, line.loops, line.indicators))
  print(("  the paper's rows: no route in %d, a longer one in %d; up to %d rows too few"):format(
    lost, longer, line.rows_missing))
  print(("  Hopfield's form: a valid route in %d of %d with at most 120 indicators"):format(valid, tried))
end
if options.seeds < 1 then report.usage_error("--seeds: at least 1 expected, got " .. options.seeds) end
if options.seeds > 1 then
  count()
  return
end

-- Explored run after run until the shortest route is proven.
local cells = labyrinth(options.seed)
local explorer = meander.indicator.explorer { goal = cells.goal, eps = 0 }
repeat cells:explore(explorer) until explorer.state.proven
local graph = explorer:graph()
local find = finder(graph, explorer.state.start, explorer.state.at_goal)
local found = find("network", options.rows)
local oracle, relaxed = find "dijkstra", #graph <= 500 and find "hopfield" or {}

local on_route = {}
for row, indicator in ipairs(found.route or {}) do on_route[row] = indicator end

-- The first `shown` rows: 1 where a neuron fired, 3 on the route once all rows are there.
local function sheet(shown, route)
  local matrix = {}
  for row = 1, #found.rows do
    matrix[row] = {}
    for column = 1, #graph do matrix[row][column] = 0 end
    if row <= shown then
      for _, neuron in ipairs(found.rows[row]) do matrix[row][neuron.indicator] = 1 end
    end
    if route and on_route[row] then matrix[row][on_route[row]] = 3 end
  end
  local fired = shown <= #found.rows and #found.rows[shown] or 0
  return meander.render.heat_map(matrix, {
    title = route and ("route of %d indicators, %.1f m"):format(#on_route, found.length or 0)
      or ("row %d: %d neurons fired"):format(shown, fired),
    x = "indicator", y = "row",
  })
end

local last = sheet(#found.rows, true)
local stem = report.path(options, "route_network")
for _, suffix in ipairs { ".svg", ".png" } do meander.render.save(last, stem .. suffix) end
meander.render.save(graph:over(cells:world()), stem .. "_graph.svg")

if options.json then
  local keys = {
    "example", "seed", "indicators", "links", "rows", "paper_rows", "truncated", "route", "length", "dijkstra", "hopfield",
    "picture",
  }
  print(json.encode({
    example = "route_network", seed = options.seed, indicators = #graph, links = #graph.links, rows = #found.rows,
    paper_rows = found.paper_rows, truncated = found.truncated, route = found.route, length = found.length or 0 / 0,
    dijkstra = oracle.length, hopfield = relaxed.length or 0 / 0, picture = stem .. ".png",
  }, keys))
  return
end

meander.render.animate(function(frame)
  if frame <= #found.rows then return sheet(frame) end
  return frame <= #found.rows + 6 and last or nil
end, { rate = options.rate })
show(graph:over(cells:world()))
print(("indicators %d, links %d; %d rows until all was quiet, the paper's equation says %d%s"):format(
  #graph, #graph.links, #found.rows, found.paper_rows, found.truncated and ": too few, the network was cut off" or ""))
for _, candidate in ipairs(found.candidates) do
  print(("  layer %2d offers a route of %.1f m"):format(candidate.rows, candidate.length))
end
print(found.route and ("selected   %.1f m over %d indicators; Dijkstra %.1f m"):format(found.length, #found.route, oracle.length)
  or "selected   none: no layer has a route")
print("relaxed    " .. (relaxed.length and ("%.1f m"):format(relaxed.length) or "no layer of Hopfield's form came to rest on a route"))
print(("pictures: %s.svg .png, the graph: %s_graph.svg"):format(stem, stem))

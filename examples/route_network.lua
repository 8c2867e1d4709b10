-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The neural network that finds the shortest route, row by row: a labyrinth is explored, its indicators are the columns,
-- and excitation spreads from the start until a row stays quiet. The last picture has the winning route in it.
--
--   ./meander examples/route_network.lua --size 12 --rate 4
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "shows how the network finds the shortest route",
  { "--kind NAME", default = "mixed", values = { "backtracker", "prim", "mixed" }, help = "how the labyrinth grows" },
  { "--size N", default = 9, help = "cells along each side" },
  { "--loops P", default = 0.1, help = "share of inner walls that are taken away" },
  { "--seed N", default = 1, help = "seed of the labyrinth" },
  { "--rows NAME", default = "adaptive", values = { "adaptive", "paper" }, help = "how many rows the network has" },
  { "--rate N", default = 3.0, help = "rows per second on a terminal" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}
if options.size < 2 or options.size > 60 then report.usage_error("--size: 2 to 60 expected, got " .. options.size) end
if options.loops < 0 or options.loops > 1 then report.usage_error("--loops: 0 to 1 expected, got " .. options.loops) end
if options.rate < 0.1 or options.rate > 100 then report.usage_error("--rate: 0.1 to 100 expected, got " .. options.rate) end

-- Explored to the last corner: run after run until the shortest route is proven.
local cells = meander.indicator.labyrinth {
  kind = options.kind, size = options.size, loops = options.loops, seed = options.seed,
}
local explorer = meander.indicator.explorer { goal = cells.goal, eps = 0 }
repeat cells:explore(explorer) until explorer.state.proven
local graph = explorer:graph()

local links = {}
for i, link in ipairs(graph.links) do links[i] = { link.a, link.b, link.length } end
local function find(method, rows)
  return meander.indicator.shortest_path {
    links = links, start = explorer.state.start, goal = explorer.state.at_goal, method = method, rows = rows,
  }
end
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
    example = "route_network", seed = options.seed, indicators = #graph, links = #links, rows = #found.rows,
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
  #graph, #links, #found.rows, found.paper_rows, found.truncated and ": too few, the network was cut off" or ""))
for _, candidate in ipairs(found.candidates) do
  print(("  layer %2d offers a route of %.1f m"):format(candidate.rows, candidate.length))
end
print(found.route and ("selected   %.1f m over %d indicators; Dijkstra %.1f m"):format(found.length, #found.route, oracle.length)
  or "selected   none: no layer has a route")
print("relaxed    " .. (relaxed.length and ("%.1f m"):format(relaxed.length) or "no layer of Hopfield's form came to rest on a route"))
print(("pictures: %s.svg .png, the graph: %s_graph.svg"):format(stem, stem))

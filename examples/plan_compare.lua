-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- All planners and all ways to read off a path, on maps of cells: lengths over those of Theta*, turning, clearance, and
-- what the landscape cost. From each start all paths lead to the same target; the landscape is solved once.
--
--   ./meander examples/plan_compare.lua --maps free,walls,rooms,clutter
--   ./meander examples/plan_compare.lua --maps free --starts 25 den520d.map AR0011SR.map
local json = require "meander.json"
local report = require "meander.report"

local own = { "free", "walls", "rooms", "clutter" }
local options = require "meander.arguments" {
  about = "compares planners and paths on maps of cells",
  { "--seed N", default = 2000, help = "seed of maps, targets and starts" },
  { "--json", help = "one JSON object per line of the table" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
  { "--maps LIST", default = "walls", help = "own maps, by name: " .. table.concat(own, ",") .. "; - for none" },
  { "--size N", default = 120, least = 20, most = 2000, help = "own maps: cells along a side" },
  { "--starts N", default = 5, least = 1, help = "starts on each map" },
  { "FILE.map ...", help = "maps of movingai.com", rest = true },
}

-- A sequence of numbers that depends on the seed alone (Lehmer's generator).
local state = (options.seed * 7919 + 12345) % 2147483646 + 1
local function below(n)
  state = state * 48271 % 2147483647
  return state // 127 % n
end

local function empty_rows(n, value)
  local rows = {}
  for y = 1, n do
    rows[y] = {}
    for x = 1, n do rows[y][x] = value end
  end
  return rows
end

local draw = {}
function draw.free(n) return empty_rows(n, 0) end
function draw.walls(n)
  local rows = empty_rows(n, 0)
  for wall = 1, 5 do
    local x, gap = wall * n // 6, below(n - n // 8) + 1
    for y = 1, n do
      if y < gap or y > gap + n // 8 then rows[y][x] = 1 end
    end
  end
  return rows
end
function draw.rooms(n)
  local rows, side = empty_rows(n, 0), 12
  for y = 1, n do
    for x = 1, n do
      if x % side == 0 or y % side == 0 then rows[y][x] = 1 end
    end
  end
  for row = 0, n // side do
    for column = 0, n // side do
      local x, y = math.min(column * side + 2 + below(8), n), math.min(row * side + 2 + below(8), n)
      for door = 0, 1 do
        local upper, right = (row + 1) * side, (column + 1) * side
        if upper <= n and x + door <= n and below(10) < 8 then rows[upper][x + door] = 0 end
        if right <= n and y + door <= n and below(10) < 8 then rows[y + door][right] = 0 end
      end
    end
  end
  return rows
end
function draw.clutter(n)
  local rows = empty_rows(n, 0)
  for y = 1, n do
    for x = 1, n do rows[y][x] = below(100) < 20 and 1 or 0 end
  end
  return rows
end

local function own_map(name)
  if not draw[name] then report.usage_error(("--maps: %s expected, got '%s'"):format(table.concat(own, ", "), name)) end
  return meander.planning.map { cells = draw[name](options.size), resolution = 1 }
end

-- A target, and starts from which Theta* finds a way to it of at least a quarter of the map's width.
local function tasks(map)
  local function cell() return { below(map.width) + 0.5, below(map.height) + 0.5 } end
  for _ = 1, 1000 do
    local target, starts = cell(), {}
    for _ = 1, 40 * options.starts do
      local start = cell()
      local straight = meander.planning.plan { map = map, start = start, target = target, planner = "theta_star" }
      if straight and straight.measures.length > map.width / 4 then starts[#starts + 1] = { start, straight } end
      if #starts == options.starts then return target, starts end
      if map:solid(target[1], target[2]) then break end
    end
  end
  report.failure "no target that can be reached from far away"
end

local kinds = {
  { "distance_transform", "log_slope" }, { "distance_transform", "gradient" }, { "neural_map", "steepest" },
  { "neural_map", "slope" }, { "neural_map", "log_slope" }, { "neural_map", "gradient" }, { "harmonic", "gradient" },
  { "astar", "way" }, { "theta_star", "way" },
}

local function mean(sum, n) return n > 0 and sum / n or 0 / 0 end

-- Solves again and again for 20 ms at least.
local function nanoseconds_a_cell(map, planner, target, start)
  local began, count, plan = os.clock(), 0, nil
  repeat
    plan = meander.planning.plan { map = map, target = target, planner = planner, start = start }
    count = count + 1
  until os.clock() - began > 0.02
  return (os.clock() - began) / count * 1e9, plan
end

local pictures = {}
local function compare(name, map)
  local target, starts = tasks(map)
  local cells
  for _, kind in ipairs(kinds) do
    local planner, path = table.unpack(kind)
    local search = path == "way"
    local time, plan = nanoseconds_a_cell(map, planner, target, search and starts[1][1] or nil)
    cells = cells or plan.statistics.cells
    local n, length, turning, clearance, relaxations = 0, 0, 0, 0, 0
    for _, start in ipairs(starts) do
      local way
      if search then
        way = meander.planning.plan { map = map, start = start[1], target = target, planner = planner }
        relaxations = relaxations + way.statistics.relaxations / #starts
      else
        way = plan:from(start[1], path)
      end
      if way then
        n = n + 1
        length = length + way.measures.length / start[2].measures.length
        turning, clearance = turning + way.measures.turning, clearance + way.measures.clearance_mean
        if planner == "neural_map" and path == "gradient" and n == 1 then
          pictures[#pictures + 1] = report.path(options, "plan_compare_" .. name .. ".svg")
          meander.render.save(way, pictures[#pictures])
        end
      end
    end
    local line = {
      map = name, planner = planner, path = path, n = n, length_ratio = mean(length, n), turning = mean(turning, n),
      clearance_mean = mean(clearance, n), ns_per_cell = time / cells,
      relaxations_per_cell = (search and relaxations or plan.statistics.relaxations) / cells,
      dead_units = search and 0 or plan.statistics.dead_units,
    }
    if options.json then
      print(json.encode(line))
    else
      print(("%-12s %-18s %-9s %4d %8.4f %8.2f %8.2f %9.1f %8.2f %6d"):format(line.map, line.planner, line.path, line.n,
        line.length_ratio, line.turning, line.clearance_mean, line.ns_per_cell, line.relaxations_per_cell,
        math.tointeger(line.dead_units)))
    end
  end
end

if options.maps == "-" and #options.rest == 0 then report.usage_error "--maps -: a FILE.map expected" end
-- A file that cannot be read is told before the first map is solved.
local files = {}
for i, file in ipairs(options.rest) do files[i] = report.try(report.failure, nil, meander.planning.read_map, file) end
if not options.json then
  print(("%-12s %-18s %-9s %4s %8s %8s %8s %9s %8s %6s"):format("map", "planner", "path", "n", "length", "turning",
    "clear", "ns/cell", "relax", "dead"))
end
if options.maps ~= "-" then
  for name in options.maps:gmatch "[^,]+" do compare(name, own_map(name)) end
end
for i, file in ipairs(options.rest) do compare(file:match("([^/]*)%.map$") or file, files[i]) end
if not options.json and #pictures > 0 then print("pictures: " .. table.concat(pictures, " ")) end

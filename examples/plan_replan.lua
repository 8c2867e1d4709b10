-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The map changes and the neural map follows: doors shut and open, a box comes and goes. After each edit it is told what
-- following it cost, in updates of a cell's value, against a solve of the whole map, and how far the two landscapes differ.
--
--   ./meander examples/plan_replan.lua
--   ./meander examples/plan_replan.lua --edits 1000 --size 500
--
-- The second line puts random edits on a map of rooms: blocks of 5 x 5 cells that come and go, doors that shut and open.
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "follows edits of the map, and compares that with solving anew",
  { "--seed N", default = 2000, help = "seed of the random edits" },
  { "--json", help = "one JSON object per step instead of text; of random edits, one for all" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
  { "--edits N", default = 0, least = 0, help = "so many random edits instead of the two rooms" },
  { "--size N", default = 200, least = 50, most = 2000, help = "cells along a side of the map of random edits" },
  { "--robot-radius M", default = 0.27, least = 0, help = "of the robot in the two rooms" },
}

local function empty_map(width, height, resolution)
  return meander.planning.map { world = meander.world.new { bounds = { { 0, 0 }, { width, height } } }, resolution = resolution }
end

-- The largest difference of the landscapes' slopes between cells beside each other, at every `stride`-th cell: slopes are
-- what a path follows. Where one has a value, the other must have one.
local function difference(a, b, map, stride)
  local worst, step = 0, map.resolution
  for i = 0, map.width * map.height - 1, stride do
    local x, y = (i % map.width + 0.5) * step, (i // map.width + 0.5) * step
    local va, vb = a:value(x, y), b:value(x, y)
    if (va == nil) ~= (vb == nil) then return math.huge end
    local na, nb = a:value(x + step, y), b:value(x + step, y)
    -- Across a wall values may lie far apart, and no path leads there.
    if va and na and nb and math.abs(na - va) < 5 then worst = math.max(worst, math.abs((na - va) - (nb - vb))) end
  end
  return worst
end

-- Follows the map as it is now and solves it anew, with the same solver.
local function follow(replanner, task, stride)
  local plan, why = replanner:replan()
  local step = { relaxations = math.tointeger(replanner.relaxations), plan = plan, reason = why }
  local anew = meander.planning.plan { map = task.map, target = task.target, robot_radius = task.robot_radius }
  if not anew then return step end
  step.cells, step.anew = math.tointeger(anew.statistics.cells), math.tointeger(anew.statistics.relaxations)
  if plan then step.difference = difference(plan, anew, task.map, stride) end
  return step
end

local function two_rooms()
  -- Two rooms of 4 m x 6 m with a wall between them that has two doors.
  local doors = { upper = { { 3.9, 4.4 }, { 4.1, 5.4 } }, lower = { { 3.9, 0.6 }, { 4.1, 1.6 } } }
  local box = { { 2.6, 4.2 }, { 3.0, 5.6 } }
  local map = empty_map(8, 6, 0.05)
  map:block { { 3.9, 0 }, { 4.1, 6 } }
  map:block(doors.upper, false)
  map:block(doors.lower, false)
  local task = { map = map, start = { 1, 4 }, target = { 7, 4.5 }, robot_radius = options.robot_radius }
  local possible, why = meander.planning.plan(task)
  if not possible then report.failure(why) end
  local replanner = meander.planning.replanner(task)
  local steps = {
    { "a box, far from the path", function() map:block { { 1, 0.5 }, { 1.25, 0.75 } } end },
    { "the upper door is shut", function() map:block(doors.upper) end },
    { "the lower door is shut, too", function() map:block(doors.lower) end },
    { "the upper door is open again", function() map:block(doors.upper, false) end },
    { "a box stands before it", function() map:block(box) end },
    { "the box is taken away", function() map:block(box, false) end },
  }
  if not options.json then
    print(("%-30s %9s %9s %6s %10s  %s"):format("edit", "updates", "of anew", "share", "difference", "path"))
  end
  if not options.json then print(("%-30s %9d"):format("the first solve", math.tointeger(replanner.relaxations))) end
  for i, edit in ipairs(steps) do
    edit[2]()
    local step = follow(replanner, task, 1)
    local line = {
      step = i, edit = edit[1], reason = step.reason, cells = step.cells, relaxations = step.relaxations,
      relaxations_anew = step.anew, difference = step.difference,
      length = step.plan and step.plan.measures.length, clear = step.plan and step.plan.clear,
    }
    meander.render.save(step.plan or map, report.path(options, "plan_replan_" .. i .. ".svg"))
    if options.json then
      print(json.encode(line))
    else
      print(("%-30s %9d %9d %5.1f%% %10s  %s"):format(line.edit, line.relaxations, line.relaxations_anew,
        100 * line.relaxations / line.relaxations_anew, line.difference and ("%.1e"):format(line.difference) or "-",
        line.length and ("%.2f m"):format(line.length) or line.reason))
    end
  end
  if not options.json then print("pictures: " .. options.out .. "/plan_replan_1.svg to _" .. #steps .. ".svg") end
end

-- A sequence of numbers that depends on the seed alone (Lehmer's generator).
local state = (options.seed * 7919 + 12345) % 2147483646 + 1
local function below(n)
  state = state * 48271 % 2147483647
  return state // 127 % n
end

-- Rooms of 25 x 25 cells of a metre with a door of three cells in each wall.
local function map_of_rooms(n)
  local map, doors = empty_map(n, n, 1), {}
  for wall = 25, n - 1, 25 do
    map:block { { wall, 0 }, { wall + 1, n } }
    map:block { { 0, wall }, { n, wall + 1 } }
  end
  local function door(box)
    map:block(box, false)
    doors[#doors + 1] = box
  end
  for wall = 25, n - 1, 25 do
    for room = 0, n - 1, 25 do
      local at = room + 2 + below(20)
      if at + 3 <= n then
        door { { wall, at }, { wall + 1, at + 3 } }
        door { { at, wall }, { at + 3, wall + 1 } }
      end
    end
  end
  return map, doors
end

local function random_edits(count, n)
  local map, doors = map_of_rooms(n)
  local blocks, shut = {}, {}
  local task = { map = map, start = { 10.5, 10.5 }, target = { n - 10.5, n - 10.5 }, robot_radius = 0 }
  local replanner = meander.planning.replanner(task)
  local keep = { { 8, 8 }, { n - 13, n - 13 } }
  local function spares(box)
    for _, corner in ipairs(keep) do
      if box[1][1] < corner[1] + 5 and box[2][1] > corner[1] and box[1][2] < corner[2] + 5 and box[2][2] > corner[2] then return false end
    end
    return true
  end
  local total, anew, worst, cut_off, dearest = 0, 0, 0, 0, 0
  for _ = 1, count do
    local what = below(4)
    if what == 0 and #blocks > 0 then
      map:block(table.remove(blocks, below(#blocks) + 1), false)
    elseif what == 1 then
      local door = below(#doors) + 1
      shut[door] = not shut[door]
      map:block(doors[door], shut[door])
    else
      local x, y = below(n - 5), below(n - 5)
      local box = { { x, y }, { x + 5, y + 5 } }
      if spares(box) then
        map:block(box)
        blocks[#blocks + 1] = box
      end
    end
    local step = follow(replanner, task, 17)
    total, anew = total + step.relaxations, anew + step.anew
    dearest = math.max(dearest, step.relaxations / step.anew)
    if step.plan then worst = math.max(worst, step.difference) else cut_off = cut_off + 1 end
  end
  local line = {
    edits = count, size = n, share = total / anew, largest_share = dearest, relaxations = total // count,
    relaxations_anew = anew // count, max_difference = worst, cut_off = cut_off,
  }
  if options.json then
    print(json.encode(line))
  else
    print(("%d edits of a map of %d x %d: %d updates on average against %d anew, %.1f %% (at most %.0f %%)"):format(count, n, n,
      line.relaxations, line.relaxations_anew, 100 * line.share, 100 * dearest))
    print(("largest difference of slopes between followed and anew: %.1e; cut off %d times"):format(worst, cut_off))
  end
end

if options.edits > 0 then random_edits(options.edits, options.size) else two_rooms() end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The minimal model grows beside the whole map: places, lights and touches over time, what they take in bytes, and what it
-- costs to recognise places by it. Means over seeds with 95 % intervals.
--
--   ./meander examples/alice_minimal.lua --world all --seeds 20
local alice = require "meander.alice"
local candidates = require "meander.candidates"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "compares the minimal topologic model with the whole map",
  { "--world NAMES", default = "alice_loop", help = "alice_loop, alice_rooms, alice_grid, with commas, or all" },
  { "--samples N", default = 5000, least = 1, most = 1000000, help = "to gather" },
  { "--seeds N", default = 1, least = 1, most = 100000, help = "runs" },
  { "--first-seed S", default = 2000, least = 0, help = "their seeds begin here; 1 to 999 are for tuning" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--json", help = "one JSON object per line instead of text" },
  { "--out DIR", default = "out", help = "folder for the C header of the first run; none when empty" },
}
local marks = { 500, 1000, 2000, 5000, 10000, 20000 }
local figures = {
  "cells", "geometry", "light", "touch", "light_share", "touch_share", "bytes_full", "bytes_minimal", "bytes_quantised",
  "smaller", "recognised", "recognised_quantised", "by_senses_full", "by_senses",
}
local kLook = 25 -- samples between two recognitions, in the last fifth of a run

local function distance(a, b) return math.sqrt((a.x - b.x) ^ 2 + (a.y - b.y) ^ 2) end

local function trial(name, seed)
  local minimal, grown, looks = nil, {}, 0
  local right = { recognised = 0, recognised_quantised = 0, by_senses_full = 0, by_senses = 0 }
  alice.explore {
    world = name, seed = seed, samples = options.samples,
    each = function(sample, robot)
      minimal = minimal or meander.topology.minimal { map = robot.map }
      minimal:step(robot.map)
      local last = sample == options.samples
      if sample > 0.8 * options.samples and sample % kLook == 0 then
        local here = { x = robot.map.pose[1], y = robot.map.pose[2] }
        local function look(name, there) right[name] = right[name] + (distance(there, here) < 0.5 and 1 or 0) end
        looks = looks + 1
        look("recognised", minimal:recognise(robot.map))
        look("recognised_quantised", minimal:recognise(robot.map, true))
        look("by_senses", minimal:recognise(robot.map, false, true))
        local alike = robot.map:alike()
        for _, place in ipairs(robot.map.places) do
          if place.number == alike then look("by_senses_full", place.position) end
        end
      end
      for _, mark in ipairs(marks) do
        if sample == mark or (last and mark > sample and not grown[sample]) then
          local sizes = minimal:sizes(robot.map)
          grown[sample] = {
            cells = #robot.map, geometry = sizes.geometry, light = sizes.light, touch = sizes.touch,
            light_share = sizes.light / sizes.geometry, touch_share = sizes.touch / sizes.geometry,
            bytes_full = sizes.bytes_of_map, bytes_minimal = sizes.bytes, bytes_quantised = sizes.bytes_quantised,
            smaller = sizes.bytes_of_map / sizes.bytes,
          }
          for key, count in pairs(right) do grown[sample][key] = last and looks > 0 and count / looks or nil end
        end
      end
    end,
  }
  if options.out ~= "" and seed == options.first_seed then minimal:save_c(report.path(options, name .. ".h"), name) end
  local list = {}
  for sample, sizes in pairs(grown) do list[#list + 1] = { sample = sample, sizes = sizes } end
  table.sort(list, function(a, b) return a.sample < b.sample end)
  return list
end

for _, name in ipairs(candidates.chosen(options.world, alice.worlds, "world")) do
  local trials = alice.trials(options, function(seed) return trial(name, seed) end)
  for k, mark in ipairs(trials[1]) do
    local sizes = {}
    for i, list in ipairs(trials) do sizes[i] = list[k].sizes end
    alice.print(options, { { "world", name }, { "n", #trials }, { "samples", mark.sample } }, sizes, figures)
  end
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- ALICE explores a world by touch and light with wheels that slip 20 to 25 % of every way, and builds a topologic map that
-- keeps it localised. With and without the correction by the map; means over seeds with 95 % intervals.
--
--   ./meander examples/alice_explore.lua --world alice_rooms --seeds 20
local alice = require "meander.alice"
local candidates = require "meander.candidates"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "explores with a topologic map",
  { "--world NAMES", default = "alice_loop", help = "alice_loop, alice_rooms, alice_grid, with commas, or all" },
  { "--samples N", default = 5000, least = 1, most = 1000000, help = "to gather; one every 5 cm" },
  { "--drift NAME", default = "alice", values = { "alice", "none", "good", "poor" }, help = "errors of the odometry" },
  { "--correction WHICH", default = "both", values = { "both", "on", "off" }, help = "correction by the map" },
  { "--seeds N", default = 1, least = 1, most = 100000, help = "runs" },
  { "--first-seed S", default = 2000, least = 0, help = "their seeds begin here; 1 to 999 are for tuning" },
  { "--jobs N", default = 0, least = 0, most = 1024, help = "worker processes; 0: one per core" },
  { "--json", help = "one JSON object per line instead of text" },
  { "--out DIR", default = "out", help = "folder for the pictures of the first run; none when empty" },
}
local figures = {
  "error_mean", "error_max", "error_last", "error_aligned", "recall", "precision", "cells", "places_rms", "long_links",
  "contacts",
}

-- The share of links whose places truly lie more than 0.7 m apart: twice the scale of positions.
local function long_links(robot)
  local long, known = 0, 0
  for _, link in ipairs(robot.map.links) do
    local a, b = robot.scores:true_place(robot.map, link.a), robot.scores:true_place(robot.map, link.b)
    if a and b then
      known = known + 1
      if (a.x - b.x) ^ 2 + (a.y - b.y) ^ 2 > 0.7 ^ 2 then long = long + 1 end
    end
  end
  return known > 0 and long / known or nil
end

for _, name in ipairs(candidates.chosen(options.world, alice.worlds, "world")) do
  for _, correction in ipairs { true, false } do
    local wanted = options.correction == "both" or (options.correction == "on") == correction
    local trials = wanted and alice.trials(options, function(seed)
      local robot = alice.explore {
        world = name, seed = seed, samples = options.samples, correction = correction, drift = options.drift,
      }
      local summary = robot.scores:summary()
      summary.cells, summary.contacts = #robot.map, robot.sim.state.contacts
      summary.places_rms, summary.long_links = robot.scores:map_error(robot.map), long_links(robot)
      if options.out ~= "" and seed == options.first_seed then
        local stem = report.path(options, ("%s_%s"):format(name, correction and "corrected" or "dead_reckoning"))
        meander.render.save(robot.map:over(robot.world), stem .. ".svg")
        robot.map:save(stem .. ".graphml")
      end
      return summary
    end)
    if trials then
      local words = { { "world", name }, { "correction", correction }, { "n", #trials }, { "samples", options.samples } }
      alice.print(options, words, trials, figures)
    end
  end
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- The office again, live: a drive that is watched in the terminal, and how the clearance went on the way. Without a
-- terminal it only drives, and shows the last picture in plain characters.
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "drives through the office and shows it live",
  { "--speed N", default = 4, help = "simulated seconds per second; 0: as fast as it goes" },
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the picture and the record" },
}

local world = meander.world.open "worlds/office.toml"
local sim = meander.sim.new { world = world, robot = "nomad200", sonar = "nomad", seed = options.seed }
local drive = { navigator = "potential_field", subgoals = { "door_a", "hall", { 8.5, 4.5 } } }

local run
if options.json then
  run = sim:drive(drive)
else
  drive.speed = options.speed
  run = watch(sim, drive)
  show(meander.render.curve(run:trace "clearance", { title = "clearance on the way", x = "cycle", y = "[m]" }))
end

report.run("watch_run", run, options)

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A simulated Nomad 200 crosses an office by sonar alone, three subgoals on the way. Leaves a picture and a record.
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "drives a Nomad 200 through the office by sonar",
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the picture and the record" },
}

local world = meander.world.open "worlds/office.toml"
local sim = meander.sim.new { world = world, robot = "nomad200", sonar = "nomad", seed = options.seed }
local run = sim:drive { navigator = "potential_field", subgoals = { "door_a", "door_c", "meeting" } }

report.run("first_run", run, options)

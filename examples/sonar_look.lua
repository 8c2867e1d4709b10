-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- One scan of the sixteen sonars, drawn: the ideal sonar of the papers against the real one, which misses slanted walls,
-- hears corners and bounces. The gap between the two is why sonar navigation is interesting.
local json = require "meander.json"
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "draws one scan, ideal against real",
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object per preset instead of text" },
  { "--out DIR", default = "out", help = "folder of the pictures" },
}

local world = meander.world.open "worlds/office.toml"
for _, preset in ipairs { "ideal", "nomad", "real" } do
  local reading = meander.sensor.scan { world = world, sonar = preset, seed = options.seed }
  local path = report.path(options, "sonar_" .. preset .. ".svg")
  reading:save(path)
  local ranges = reading.ranges:totable()
  if options.json then
    print(json.encode({ example = "sonar_look", seed = options.seed, sonar = preset, ranges = ranges, picture = path },
      { "example", "seed", "sonar", "ranges", "picture" }))
  else
    show(reading)
    print(("%s: " .. ("%.2f "):rep(#ranges)):format(preset, table.unpack(ranges)) .. "m, picture " .. path)
  end
end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Trains networks that read sonars: puts the robot into rooms made from seeds, notes what its sonars read and which cells
-- around it are occupied, free or hidden, learns from some rooms, watches others, and measures on rooms of a third kind.
-- The weights that come with the program were made by
--
--   ./meander examples/train_sonar_model.lua --sonar ideal --network all --out models
--   ./meander examples/train_sonar_model.lua --sonar real --network all --out models
--
-- For a robot of your own, name it with --robot; for a sonar of your own, change what is given as `sonar` below.
local json = require "meander.json"
local candidates = require "meander.candidates"
local rooms = require "meander.sonar_rooms"
local report = require "meander.report"

local networks = { "nn1", "nn2", "nn3", "nn4", "nn5" }
local options = require "meander.arguments" {
  about = "trains networks that read sonars",
  { "--network NAMES", default = "nn4", help = "nn1 to nn5, several with commas, or all" },
  { "--sonar NAME", default = "real", values = meander.sensor.sonars(), help = "model of the sonars" },
  { "--robot NAME", default = "nomad200", values = meander.robot.platforms(), help = "kind of robot" },
  { "--hidden UNITS", default = "16,16", help = "units of the hidden layers" },
  { "--method NAME", default = "adam", values = { "adam", "backprop" }, help = "how it learns" },
  { "--epochs N", default = 40, least = 1, help = "times that every cell is seen" },
  { "--rooms N", default = 40, least = 1, help = "rooms to learn in; a quarter as many to watch and to measure" },
  { "--poses N", default = 50, least = 1, help = "places in each" },
  { "--seed N", default = 1, least = 0, help = "seed of rooms, places and weights" },
  { "--json", help = "one JSON object per network instead of text" },
  { "--out DIR", default = "out", help = "folder of the weights and of the picture of the losses" },
}

local hidden = {}
for word in (options.hidden .. ","):gmatch "([^,]*)," do
  local units = word:match "^%s*%d+%s*$" and math.tointeger(tonumber(word))
  if not units or units < 1 then
    report.usage_error("--hidden: units of each layer with commas, such as 16,16, expected, got '" .. options.hidden .. "'")
  end
  hidden[#hidden + 1] = units
end

local function say(...) if not options.json then print(...) end end

-- Rooms to learn in, to watch and to measure on have seeds far apart.
local function lessons(first_room, count)
  local worlds = {}
  for i = 1, count do worlds[i] = rooms.make(first_room + options.seed * 10000 + i).world end
  return meander.mapping.lessons {
    worlds = worlds, robot = options.robot, sonar = options.sonar, poses = options.poses, seed = options.seed + first_room,
  }
end

local some = math.max(1, options.rooms // 4)
local training, validation, test = lessons(100000000, options.rooms), lessons(200000000, some), lessons(300000000, some)
say("to learn from:", training)
say("to watch:     ", validation)
say("to measure on:", test)

local function made_by(name)
  return ("examples/train_sonar_model.lua --network %s --sonar %s --robot %s --hidden %s --method %s --epochs %d --rooms %d --poses %d --seed %d")
    :format(name, options.sonar, options.robot, options.hidden, options.method, options.epochs, options.rooms, options.poses, options.seed)
end

for _, name in ipairs(candidates.chosen(options.network, networks, "network")) do
  local losses = {}
  local network = meander.mapping.train {
    lessons = training, validation = validation, network = name, hidden = hidden, method = options.method,
    epochs = options.epochs, seed = options.seed, show = not options.json, sonar = options.sonar, made_by = made_by(name),
    on_epoch = function(epoch) losses[#losses + 1] = epoch.validation end,
  }
  local file = ("%s_%s"):format(name, options.sonar)
  network:save(report.path(options, file .. ".txt"))
  local exact = meander.mapping.model(network, { robot = options.robot }):score(test)
  local table_ = meander.mapping.model(network, { robot = options.robot, table = true }):score(test)
  local words = { title = name .. ", sonar " .. options.sonar, x = "epoch", y = "cross-entropy [nat]" }
  meander.render.save(meander.render.curve(losses, words), report.path(options, file .. ".svg"))
  if options.json then
    print(json.encode({ model = name, preset = options.sonar, n = #test, ce = exact.ce, brier = exact.brier, auc = exact.auc,
      table_ce = table_.ce, losses = losses }, { "model", "preset", "n", "ce", "brier", "auc", "table_ce", "losses" }))
  else
    print(("%s: cross-entropy %.3f, Brier %.3f, AUC %.3f; as a table %.3f"):format(name, exact.ce, exact.brier, exact.auc, table_.ce))
  end
end

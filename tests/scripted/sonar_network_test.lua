-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Networks that read sonars, as scripts train and use them.
local rooms = require "meander.sonar_rooms"

local function lessons(first, count, poses)
  local worlds = {}
  for i = 1, count do worlds[i] = rooms.make(first + i).world end
  return meander.mapping.lessons { worlds = worlds, sonar = "real", poses = poses, seed = first }
end

describe("a network", function()
  it("trained anew on a small set is nearly as good as the shipped one, and far better than the cones", function()
    local training, test = lessons(500000, 8, 30), lessons(600000, 5, 20)
    local network = meander.mapping.train { lessons = training, network = "nn4" }
    local anew = meander.mapping.model(network):score(test).ce
    local shipped = meander.mapping.model("nn4", { preset = "real" }):score(test).ce
    expect(shipped):less_than(anew + 0.02)
    expect(anew):less_than(shipped + 0.12)
    expect(shipped):less_than(0.45)
    expect(meander.mapping.model("elfes"):score(test).ce):greater_than(shipped + 0.1)
  end)

  it("is the same from the same seed, and after it was saved", function()
    local training = lessons(500000, 2, 10)
    local function trained(seed) return meander.mapping.train { lessons = training, hidden = { 4 }, epochs = 3, seed = seed } end
    local function text(network)
      local path = os.tmpname()
      network:save(path)
      local file <close> = assert(io.open(path))
      return file:read "a"
    end
    local first, path = trained(1), os.tmpname()
    expect(text(trained(1))):equals(text(first))
    expect(text(trained(2))):never():equals(text(first))
    first:save(path)
    expect(text(meander.mapping.network(path))):equals(text(first))
  end)

  it("tells how it learns, and stops when the function fails", function()
    local training, epochs = lessons(500000, 2, 10), {}
    meander.mapping.train { lessons = training, validation = training, hidden = { 4 }, epochs = 3,
      on_epoch = function(epoch) epochs[#epochs + 1] = epoch end }
    expect(#epochs):equals(3)
    expect(epochs[3].validation):less_than(epochs[1].validation)
    local ok = pcall(meander.mapping.train, { lessons = training, on_epoch = function() error "enough" end })
    expect(ok):equals(false)
  end)
end)

describe("a sensor model", function()
  it("can be a function", function()
    local model = meander.mapping.model(function(ranges, range, bearing)
      local told = {}
      for i = 1, #range do told[i] = range[i] < ranges[1] and -1 or 1 end
      return told
    end)
    local ranges = {}
    for i = 1, 16 do ranges[i] = 1 end
    local told = model:evaluate(ranges, { { 0.5, 0 }, { 0, 1.5 } })
    expect(told[1]):equals(-1)
    expect(told[2]):equals(1)
    local bad = meander.mapping.model(function() return { 1 } end)
    expect((pcall(bad.evaluate, bad, ranges, { { 1, 0 }, { 2, 0 } }))):equals(false)
  end)

  it("ships networks that tell what they are and how to make them again", function()
    local names = meander.mapping.models()
    expect(#names):equals(7)
    for _, name in ipairs(names) do
      if name:find "^nn" then
        local network = meander.mapping.network("models/" .. name .. "_real.txt")
        expect(network.layers[#network.layers]):equals(1)
        expect(network.made_by:find("--network " .. name, 1, true) ~= nil):equals(true)
      end
    end
  end)

  it("makes maps, by name, as an object, as a network", function()
    local sim = meander.sim.new { world = rooms.make(3).world, start = rooms.make(3):place(), sonar = "ideal" }
    local function occupied(model)
      local map = meander.mapping.map { model = model }
      map:update(sim.observation)
      return map:matrix("local"):all():sum()
    end
    local network = meander.mapping.network "models/nn4_ideal.txt"
    expect(occupied "nn4"):equals(occupied(network))
    expect(occupied "nn4"):equals(occupied(meander.mapping.model(network)))
  end)
end)

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Worlds as a script edits them.
describe("editing a world", function()
  local world, untouched

  before_each(function()
    world = meander.world.open "worlds/office.toml"
    untouched = world:fork()
  end)

  local function add_crate() return world:add_box { center = { 3, 2 }, size = { 0.6, 0.4 }, heading = deg(30), name = "crate" } end

  it("adds a thing and takes it back", function()
    add_crate()
    expect(world):has("crate", 1):never():equals(untouched)
    world:undo()
    expect(world):equals(untouched):never():has("crate")
    world:redo()
    expect(world):has "crate"
  end)

  it("gives a removed thing its handle back", function()
    local crate = add_crate()
    world:remove "crate"
    expect(crate.alive):is_false()
    expect(function() world:move(crate, { 1, 0 }) end):throws "removed"
    world:undo()
    expect(crate.alive):is_true()
    expect(world:get(crate).center):near({ 3, 2 }, 1e-12)
  end)

  it("keeps a world whose transaction fails", function()
    local function half() world:transaction(function()
      add_crate()
      error "no more"
    end) end
    expect(half):throws "no more"
    expect(world):equals(untouched)
  end)

  it("says what differs", function()
    add_crate()
    expect(untouched:diff(world)):has_length(1)
    expect(untouched:diff(world)[1]):contains "crate"
  end)

  it("reads what it wrote", function()
    local path = os.tmpname() .. ".toml"
    add_crate()
    world:save(path)
    local read = meander.world.open(path)
    os.remove(path)
    expect(read):equals(world)
    expect(read:to_toml()):equals(world:to_toml())
  end)

  it("undoes a hundred random edits", function(seed)
    for i = 1, 100 do
      local x, y = 1 + 9 * math.random(), 1 + 6 * math.random()
      world:add_disc { center = { x, y }, radius = 0.01 + 0.05 * math.random(), name = "dot_" .. i }
      if math.random() < 0.3 then world:remove("dot_" .. i) end
    end
    world:undo(1000)
    expect(world):equals(untouched)
    expect(seed):is_a "integer"
  end)

  it("asks for the right name", function()
    expect(function() world:remove "hal" end):throws "did you mean 'hall'"
    expect(function() world:add_box { center = { 3, 2 }, sise = { 1, 1 } } end):throws "did you mean 'size'"
  end)
end)

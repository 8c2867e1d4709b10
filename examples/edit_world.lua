-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Edits a world and takes it back: add, move, open a door, undo, redo, all or nothing, save, reload, compare.
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "adds, moves, undoes, saves and reloads",
  { "--seed N", default = 7, help = "seed of all random streams" },
  { "--json", help = "one JSON object instead of text" },
  { "--out DIR", default = "out", help = "folder of the world file and the picture" },
}

local function say(...) if not options.json then print(...) end end

local world = meander.world.open "worlds/office.toml"
local original = world:fork()
say(world)

local crate = world:add_box { center = { 2.0, 1.2 }, size = { 0.4, 0.3 }, heading = deg(30), name = "crate" }
say("added", crate)
world:move("crate", { 0.2, 0.1 })
world:turn("crate", deg(15))
say("the difference so far:")
for _, line in ipairs(original:diff(world)) do say("  " .. line) end

-- All or nothing: the second step fails, so the first is taken back too.
local ok, message = pcall(function()
  world:transaction(function()
    world:add_disc { center = { 2.0, 2.4 }, radius = 0.1, name = "bin" }
    world:add_disc { center = { 2.0, 2.4 }, radius = -1, name = "nonsense" }
  end)
end)
say("a transaction that fails leaves nothing behind:", ok, message)

local undone = world:undo(3)
local restored = world == original
say("undone steps:", undone, "equal to the original:", restored)
world:redo(3)

local path = report.path(options, "edited.toml")
world:save(path)
local again = meander.world.open(path)
local same = again == world

-- The drive sees the edited world.
local sim = meander.sim.new { world = again, robot = "nomad200", seed = options.seed }
local run = sim:drive { navigator = "potential_field", subgoals = { "door_a" } }
say("saved, reloaded, equal:", same)

report.run("edit_world", run, options, { undo_restores = restored, reload_equal = same })

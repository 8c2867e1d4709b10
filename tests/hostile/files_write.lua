-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Every way to write, make, remove or rename outside of the folder.
-- exit: 0
-- output: ^refused$
local folder = arg[1]
local world = meander.world.new { start = { 1, 1, 0 } }
local sim = meander.sim.new { world = world }
local run = sim:drive { navigator = function() return 0.3, 0 end, subgoals = { { 2, 1 } } }
local reading = meander.sensor.scan { world = world }
for _, name in ipairs { "../made", folder .. "/made", "up/made", "dangling", "link", "up/secret", "box/../../made", "/tmp/../" .. folder .. "/made" } do
  for _, suffix in ipairs { "", ".toml", ".svg", ".png", ".csv", ".jsonl", ".yaml", ".txt" } do
    local path = name .. suffix
    pcall(function() local f = io.open(path, "w") if f then f:write "x" f:close() end end)
    pcall(function() local f = io.open(path, "a+") if f then f:write "x" f:close() end end)
    pcall(os.remove, path)
    pcall(os.rename, path, "stolen" .. suffix)
    pcall(os.rename, "hostile.lua", path)
    pcall(meander.make_folder, path)
    pcall(meander.make_folder, path .. "/deeper")
    for _, object in ipairs { world, sim, run, reading } do pcall(object.save, object, path) end
    pcall(world.export_ros, world, path)
  end
end
os.remove "../secret.txt"
os.rename("up/secret.txt", "mine.txt")
os.rename("up", "dir")
local mine = io.open "mine.txt"
print(mine and mine:read "a" or "refused")

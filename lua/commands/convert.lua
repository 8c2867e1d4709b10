-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- meander convert IN OUT: reads any importable map, writes it as a world, a ROS map or a picture.
local report = require "meander.report"

local options = require "meander.arguments" {
  about = "reads a world (.toml), ROS map (.yaml), floor plan (image), BARN world (.csv) or MovingAI map (.map);\n"
    .. "writes by the suffix of OUT: .toml world, .yaml ROS map with its .pgm, .svg or .png picture",
  { "--resolution M", default = 0.05, help = "metres per pixel of an image or cell of a map; of a ROS map that is written" },
  { "--unknown HOW", default = "auto", values = { "auto", "free", "occupied" }, help = "unknown cells of a ROS map" },
  { "--index N", default = 0, help = "which world of a BARN file" },
  { "--force", help = "write over a file that is there" },
  { "IN", help = "file to read" },
  { "OUT", help = "file to write" },
}

local writers = {
  toml = function(world, path) world:save(path) end,
  svg = function(world, path) world:save(path) end,
  png = function(world, path) world:save(path) end,
  yaml = function(world, path) world:export_ros(path, { resolution = options.resolution }) end,
}

local suffix = options.OUT:match "%.(%w+)$"
local write = writers[suffix or ""]
if not write then
  report.usage_error(("OUT: .toml, .yaml, .svg or .png expected, got '%s'%s"):format(options.OUT, suffix and "" or ", no suffix"))
end
local there = io.open(options.OUT, "r")
if there then
  there:close()
  if not options.force then report.usage_error("'" .. options.OUT .. "' exists already (--force writes over it)") end
end

-- "start, 1 door, 13 places": what is in the world and in no map of cells, where doors are walls or nothing.
local function lost(world)
  local count, parts = {}, { world.start and "start" }
  for _, thing in ipairs(world:things()) do count[thing.kind] = (count[thing.kind] or 0) + 1 end
  for _, kind in ipairs { "door", "mover", "light", "place" } do
    if count[kind] then parts[#parts + 1] = ("%d %s%s"):format(count[kind], kind, count[kind] > 1 and "s" or "") end
  end
  return table.concat(parts, ", ")
end

-- What went wrong in a call, without the names of the functions of this program.
local function checked(done, ...)
  if done then return ... end
  local message = tostring((...))
  if message:find "interrupted$" then error(message, 0) end
  report.failure((message:gsub("^%[[^%]]*%]:%d+: [%w_.:]+: ", "")))
end

local world, notes = checked(pcall(meander.world.import, options.IN, {
  resolution = options.resolution, unknown = options.unknown, index = options.index,
}))
for _, line in ipairs(notes) do io.stderr:write(line, "\n") end
checked(pcall(write, world, options.OUT))
if suffix == "yaml" and lost(world) ~= "" then
  io.stderr:write("a ROS map has no room for names, nor for: ", lost(world), "\n")
end
print(tostring(world) .. " -> " .. options.OUT)

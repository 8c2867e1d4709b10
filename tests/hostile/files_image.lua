-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- A ROS map in the folder names a picture outside of it.
-- exit: 0
-- output: ^refused refused refused refused$
local answers = {}
for i, image in ipairs { "../secret.pgm", arg[1] .. "/secret.pgm", "up/secret.pgm", "/proc/self/environ" } do
  local file <close> = assert(io.open("map.yaml", "w"))
  file:write("image: ", image, "\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
  file:flush()
  local done, problem = pcall(meander.world.import, "map.yaml")
  answers[i] = not done and problem:find("sandbox", 1, true) and "refused" or tostring(problem)
end
print(table.concat(answers, " "))

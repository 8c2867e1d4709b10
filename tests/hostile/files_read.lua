-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Every way to read what lies beside the folder.
-- exit: 0
-- output: ^refused$
local folder = arg[1]
local names = {
  "../secret.txt", folder .. "/secret.txt", "link", "up/secret.txt", "./../secret.txt", "x/../../secret.txt", "//" .. folder .. "/secret.txt",
  "up/box/link", "/etc/passwd", "/proc/self/environ", "/proc/self/cwd/../secret.txt", "/dev/stdin", "/dev/zero", "link\0.toml",
  "../secret.txt\0", ("../"):rep(500) .. "etc/passwd", ("x"):rep(100000), "", ".", "..", "~/.ssh/id_rsa", "pipe", "file:///etc/passwd",
}
local readers = {
  io.open, function(name) return io.open(name, "r+") end, function(name) return io.open(name, "a+") end, loadfile,
  function(name) for line in io.lines(name) do print(line) end end, dofile,
  require, meander.world.open, meander.world.import,
}
for _, name in ipairs(names) do
  for _, reader in ipairs(readers) do
    local done, file = pcall(reader, name)
    if done and io.type(file) then
      local text = file:read("a")
      if text and #text > 0 then print("read", name, text) end
    end
  end
end
print "refused"

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Fills the log.
-- exit: 1
-- error: sandbox: more than 8 MiB written
-- options: --sandbox-output 8
local line = ("x"):rep(1000)
while true do
  print(line)
  io.write(line)
  io.stderr:write ""
end

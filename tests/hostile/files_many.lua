-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Fills the disk with small files.
-- exit: 1
-- error: sandbox: more than 8 MiB written
-- options: --sandbox-output 8
for i = 1, 1e6 do
  local file <close> = assert(io.open("file" .. i, "w"))
  file:write "x"
end

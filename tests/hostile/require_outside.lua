-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Modules of the folder only.
-- exit: 0
-- output: ^mine refused$
local file <close> = assert(io.open("mine.lua", "w"))
file:write "return 'mine'"
file:flush()
local answer = require "mine"
for _, name in ipairs { "..secret", "../secret", "up.secret", "up/secret", arg[1] .. "/secret", arg[1]:gsub("/", ".") .. ".secret", "link", "secret" } do
  if pcall(require, name) then answer = answer .. " " .. name end
end
print(answer .. " refused")

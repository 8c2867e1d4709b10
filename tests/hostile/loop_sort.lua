-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- An order that is none.
-- exit: 1
-- error: invalid order function|sandbox: 10000000 Lua instructions used up
-- options: --sandbox-instructions 10000000
local list = {}
for i = 1, 1000 do list[i] = i end
while true do
  pcall(table.sort, list, function() return true end)
  table.sort(list, function(a, b) return a ~= b end)
end

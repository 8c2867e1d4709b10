-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: sandbox: 100000000 Lua instructions used up|computing time of 2 s used up
while true do end

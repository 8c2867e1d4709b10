-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: not enough memory \(sandbox: 128 MiB\)
local kept = {}
while true do kept[#kept + 1] = { kept } end

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- exit: 1
-- error: sandbox: 1000000 Lua instructions used up
-- options: --sandbox-instructions 1000000
::again::
goto again

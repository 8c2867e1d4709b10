-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- An error message that is larger than the memory that is left.
-- exit: 1
-- error: 50000000 bytes
error(("x"):rep(5e7), 0)

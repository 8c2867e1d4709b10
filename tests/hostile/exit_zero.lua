-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- os.exit ends the script, not the book-keeping; what follows does not run.
-- exit: 3
-- output: ^before$
print "before"
pcall(pcall, os.exit, 3)
print "after"

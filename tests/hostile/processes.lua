-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Every way to start a program.
-- exit: 0
-- output: ^nil nil nil nil nil nil nil$
print(("%s %s %s %s %s %s %s"):format(os.execute, io.popen, rawget(_G, "package"), os.getenv, os.tmpname, io.tmpfile, io.stdin))

-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Every way to start a program.
-- exit: 0
-- output: ^nothing left$
assert(rawget(_G, "package") == nil)
for library, names in pairs { [os] = { "execute", "getenv", "tmpname" }, [io] = { "popen", "tmpfile", "stdin" } } do
  for _, name in ipairs(names) do
    assert(rawget(library, name) == nil)
    local done, problem = pcall(function() return library[name] end)
    assert(not done and problem:find("the sandbox has no ", 1, true))
  end
end
print "nothing left"

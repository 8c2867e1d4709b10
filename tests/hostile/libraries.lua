-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Nothing is reachable by another name either.
-- exit: 0
-- output: ^nothing$
local seen, bad = {}, {}
local names = { execute = 1, popen = 1, getenv = 1, tmpname = 1, tmpfile = 1, setlocale = 1, loadlib = 1, searchpath = 1, dump = 1,
  sethook = 1, getregistry = 1, getupvalue = 1, setvbuf = 1, stdin = 1, input = 1, cpath = 1, searchers = 1, preload = 1, _PRELOAD = 1, _CLIBS = 1, _LOADED = 1 }
local function walk(value, path)
  if type(value) == "string" or seen[value] then return end
  seen[value] = true
  if type(value) == "table" then
    for k, v in next, value do
      if names[k] then bad[#bad + 1] = path .. "." .. tostring(k) end
      if v ~= nil then walk(v, path .. "." .. tostring(k)) end
    end
  end
  local meta = getmetatable(value)
  if type(meta) == "table" then walk(meta, path .. "~") end
end
walk(_G, "_G")
for _, name in ipairs { "io", "os", "debug", "string", "package", "_G", "coroutine", "meander.pretty", "meander.json", "meander.arguments" } do
  local done, module = pcall(require, name)
  if done then walk(module, name) end
end
print(#bad > 0 and table.concat(bad, " ") or "nothing")

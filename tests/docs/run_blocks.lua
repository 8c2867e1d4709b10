-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Runs every ```lua block of the Markdown files given, each in an environment of its own.

local failed, ran = 0, 0

local function blocks(path)
  local list, block, start = {}, nil, 0
  local number = 0
  for line in io.lines(path) do
    number = number + 1
    if block and line:match("^```%s*$") then
      list[#list + 1] = { text = table.concat(block, "\n"), line = start }
      block = nil
    elseif block then
      block[#block + 1] = line
    elseif line:match("^```lua%s*$") then
      block, start = {}, number
    end
  end
  return list
end

-- Blocks may write to files named by os.tmpname, with suffixes of their own: those are removed at the end.
local temporary, tmpname = {}, os.tmpname
os.tmpname = function()
  temporary[#temporary + 1] = tmpname()
  return temporary[#temporary]
end
local function remove_temporary()
  for _, name in ipairs(temporary) do
    for _, suffix in ipairs { "", ".csv", ".jsonl", ".pgm", ".png", ".svg", ".toml", ".yaml" } do os.remove(name .. suffix) end
  end
end

for _, path in ipairs(arg) do
  for _, block in ipairs(blocks(path)) do
    -- Lines before the block keep their number, so that a message points into the page.
    local chunk, message = load(("\n"):rep(block.line) .. block.text, "@" .. path, "t", setmetatable({}, { __index = _G }))
    local ok = chunk ~= nil
    if ok then ok, message = pcall(chunk) end
    ran = ran + 1
    if not ok then
      failed = failed + 1
      io.stderr:write(tostring(message), "\n")
    end
  end
end

remove_temporary()
print(("%d passed, %d failed"):format(ran - failed, failed))
os.exit(failed == 0 and 0 or 1, true)

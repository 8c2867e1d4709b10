-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- meander completion bash|zsh|fish: what the program and its commands say in --help, as a completion script.
local report = require "meander.report"
local shells = require "meander.completion_scripts"

local options = require "meander.arguments" {
  about = "prints what a shell needs to complete the command line of meander; for this session:\n"
    .. '  bash: eval "$(meander completion bash)"     zsh: eval "$(meander completion zsh)"     fish: meander completion fish | source',
  { "SHELL", help = "bash, zsh or fish" },
}

local script = shells[options.SHELL]
if not script then report.usage_error("SHELL: bash, zsh or fish expected, got '" .. options.SHELL .. "'") end

-- The lines that this very program writes. The parent of the shell that popen starts is the program.
local function help(command)
  local pipe <close> = assert(io.popen("exec /proc/$PPID/exe " .. command .. " --help 2>&1"))
  return pipe:read "a"
end

-- What completes a value: folders, files, or nothing.
local function kind_of(name, placeholder)
  if placeholder == "DIR" or name:find "folder$" then return "folder" end
  if placeholder == "FILE" or placeholder == "PATH" then return "file" end
  return "text"
end

-- Options stand as "  -h,--help  text", "  --seed N  text" or "  --seed INT=7", with the text perhaps in the next line.
local function options_in(text)
  local list = {}
  for line, following in text:gmatch "\n  %s*(%-[^\n]*)%f[\n]()" do
    local left, right = line:match "^(.-)%s%s+(.*)$"
    left = left or line
    right = right or text:match("^\n%s+([^\n]*)", following) or ""
    local names, value = left:match "^(%S+)%s?(%S*)"
    local option = { text = right:gsub("%s*%[[^%[%]]*%]$", ""), repeats = left:find("...", 1, true) ~= nil }
    option.text = option.text:match "^[^;]*"
    for name in names:gmatch "[^,]+" do option[#option + 1] = name end
    option.value = value:match "^%w+"
    option.kind = option.value and kind_of(option[#option], option.value)
    list[#list + 1] = option
  end
  if not text:find "%-%-help%f[^%w-].*this text" then list[#list + 1] = { "--help", text = "this text" } end
  return list
end

local main = "\n" .. help ""
local commands = {}
for name, arguments, text in main:gmatch "\n  meander (%l+) ([^\n]-)  +([^\n]*)" do
  local words = { SHELL = { "bash", "zsh", "fish" }, ["[NAME]"] = {} }
  commands[#commands + 1] = {
    name = name, text = text, options = options_in("\n" .. help(name)), words = words[arguments],
  }
end
io.write(script { options = options_in(main), commands = commands })

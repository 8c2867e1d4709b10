-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- meander completion bash|zsh|fish: what the program and its commands say in --help, as a completion script.
local shells = require "meander.completion_scripts"

local options = require "meander.arguments" {
  about = "prints what a shell needs to complete the command line of meander; for this session:\n"
    .. '  bash: eval "$(meander completion bash)"     zsh: eval "$(meander completion zsh)"     fish: meander completion fish | source',
  { "SHELL", values = { "bash", "zsh", "fish" }, help = "of the script" },
}
local script = shells[options.SHELL]

-- The lines that this very program writes. The parent of the shell that popen starts is the program.
local function output(command)
  local pipe <close> = assert(io.popen("exec /proc/$PPID/exe " .. command .. " 2>&1"))
  return pipe:read "a"
end
local function help(command) return output(command .. " --help") end

-- What completes a value: folders, files, modules, or nothing.
local kinds = { DIR = "folder", FILE = "file", PATH = "file", MODULE = "module" }
local function kind_of(name, placeholder) return name:find "folder$" and "folder" or kinds[placeholder] or "text" end

-- The words of a text that ends as in "cells of a map: auto, free or occupied"; nil for others.
local function listed(text)
  local first, last = text:match "^.*: ([%w_, ]+) or ([%w_]+)$"
  if not first then return nil end
  local words = {}
  for word in (first .. ", " .. last):gmatch "[^, ]+" do words[#words + 1] = word end
  return words
end

-- What `meander doc NAME` takes: the headings of the reference, those of modules also in short.
local function documented_names()
  local names, known = {}, {}
  local function add(name)
    if name and not known[name] then names[#names + 1], known[name] = name, true end
  end
  for name in output("doc --markdown"):gmatch "\n##+ (%S+)" do
    add(name)
    add(name:match "^meander%.(.+)")
  end
  return names
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
    option.words = listed(option.text)
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
  local words = { SHELL = { "bash", "zsh", "fish" }, ["[NAME]"] = arguments == "[NAME]" and documented_names() }
  commands[#commands + 1] = {
    name = name, text = text, options = options_in("\n" .. help(name)), words = words[arguments],
  }
end
io.write(script { options = options_in(main), commands = commands, data = meander.data_folder() or "" })

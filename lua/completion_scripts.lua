-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
-- Completion scripts for bash, zsh and fish of a program that is described as
--   { options = OPTIONS, commands = { { name =, text =, options = OPTIONS, words = { ... } or nil for files }, ... } }
-- where OPTIONS is a list of { "-s", "--long", text =, value = "DIR" or nil, kind = "folder", "file", "module" or "text",
-- words = what the value may be, or nil }. Files that are not here may also be in the folder `data` of the program.
local scripts = {}

local function each(list, write)
  local parts = {}
  for _, item in ipairs(list) do parts[#parts + 1] = write(item) end
  return parts
end

-- All names of the options that `wanted` holds for.
local function names(options, wanted)
  local found = {}
  for _, option in ipairs(options) do
    if not wanted or wanted(option) then table.move(option, 1, #option, #found + 1, found) end
  end
  return found
end

-- Replaces @name@ in a template by values[name].
local function filled(template, values) return (template:gsub("@(%l+)@", values)) end

-- bash ---------------------------------------------------------------------------------------------------------------

local bash_template = [[
# Completion of meander for bash, written by `meander completion bash`.
_meander_files() {
  compopt -o filenames
  case $1 in
    folder) mapfile -t COMPREPLY < <(compgen -d -- "$cur") ;;
    file) mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
    script) mapfile -t COMPREPLY < <(_meander_words "$2"; compgen -d -- "$cur"; compgen -f -X '!*.lua' -- "$cur") ;;
    module) mapfile -t COMPREPLY < <(compgen -f -X '!*.lua' -- "$cur") && COMPREPLY=("${COMPREPLY[@]%.lua}") ;;
  esac
  case ${#COMPREPLY[@]},$1 in
    0,file | 0,script) mapfile -t COMPREPLY < <(_meander_shipped "$1") ;;
  esac
}

# Files that came with the program: they are found without their folder.
_meander_shipped() {
  local name
  cd -- @data@ 2> /dev/null && compgen -f -- "$cur" | while IFS= read -r name; do
    if [ -d "$name" ]; then
      printf '%s/\n' "$name"
    elif [ "$1" = file ] || [ "${name%.lua}" != "$name" ]; then
      printf '%s\n' "$name"
    fi
  done
}

# Words; bash takes one with a colon for several.
_meander_words() {
  local before=${COMP_LINE:0:COMP_POINT}
  before=${before##* }
  case $before in
    *:*) compgen -W "$1" -- "$before" | while IFS= read -r before; do printf '%s\n' "${before##*:}"; done ;;
    *) compgen -W "$1" -- "$cur" ;;
  esac
}

# The value of option $1; fails where it takes none.
_meander_value() {
  case $1 in
@values@    *) return 1 ;;
  esac
}

_meander() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command= i
  COMPREPLY=()
  if [ "$cur" = = ]; then  # bash takes --option=value for three words
    cur=
  elif [ "$prev" = = ]; then
    prev=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    case ${COMP_WORDS[i]} in
      @valued@) [ "${COMP_WORDS[i + 1]}" != = ] || ((i++)); ((i++)) ;;
      --) command=--; break ;;
      -?*) ;;
      *) command=${COMP_WORDS[i]}; break ;;
    esac
  done
  case $command in
    "")
      _meander_value "$prev" && return
      case $cur in
        -*) mapfile -t COMPREPLY < <(_meander_words '@options@') ;;
        *) _meander_files script '@commands@' ;;
      esac ;;
@blocks@    *) _meander_files file ;;
  esac
}
complete -F _meander meander
]]

local bash_kinds = {
  folder = "_meander_files folder", file = "_meander_files file", module = "_meander_files module", text = ":",
}
local bash_words = "mapfile -t COMPREPLY < <(_meander_words '%s')"

local function shell_quoted(text) return "'" .. text:gsub("'", "'\\''") .. "'" end

local function bash_values(options, indent)
  return table.concat(each(options, function(option)
    if not option.value then return nil end
    local completed = option.words and bash_words:format(table.concat(option.words, " ")) or bash_kinds[option.kind]
    return indent .. table.concat(option, "|") .. ") " .. completed .. " ;;\n"
  end))
end

local function bash_block(command)
  local values = bash_values(command.options, "        ")
  local rest = command.words and bash_words:format(table.concat(command.words, " ")) or "_meander_files file"
  return ("    %s)\n"):format(command.name)
    .. ("      case $prev in\n%s        *)\n"):format(values)
    .. ("          case $cur in\n            -*) %s ;;\n            *) %s ;;\n          esac ;;\n"):format(
      bash_words:format(table.concat(names(command.options), " ")), rest)
    .. "      esac ;;\n"
end

function scripts.bash(program)
  return filled(bash_template, {
    values = bash_values(program.options, "    "),
    valued = table.concat(names(program.options, function(option) return option.value end), "|"),
    options = table.concat(names(program.options), " "),
    commands = table.concat(each(program.commands, function(command) return command.name end), " "),
    blocks = table.concat(each(program.commands, bash_block)),
    data = shell_quoted(program.data),
  })
end

-- zsh ----------------------------------------------------------------------------------------------------------------

local zsh_template = [[
#compdef meander
# Completion of meander for zsh, written by `meander completion zsh`.
_meander() {
  local curcontext=$curcontext state line ret=1
  typeset -A opt_args
  _arguments -C -A '-*' \
@options@    '1:script or command:->first' \
    '*::argument:->rest' && ret=0
  case $state in
    first)
      local -a commands=(
@commands@      )
      _describe -t commands command commands && ret=0
      _files -g '*.lua' && ret=0 ;;
    rest)
      case $words[1] in
@blocks@        *) _files && ret=0 ;;
      esac ;;
  esac
  return ret
}
if [ "$funcstack[1]" = _meander ]; then _meander "$@"; else compdef _meander meander; fi
]]

local zsh_kinds = { folder = "_files -/", file = "_files", module = "_files", text = "" }

local function zsh_text(text) return (text:gsub("'", "'\\''"):gsub("([%[%]:])", "\\%1")) end

local function zsh_options(options, indent)
  return table.concat(each(options, function(option)
    local action = option.words and "(" .. table.concat(option.words, " ") .. ")" or zsh_kinds[option.kind]
    local value = option.value and (":%s:%s"):format(option.value, action) or ""
    local lines = each(option, function(name)
      local assigned = option.value and name:find "^%-%-" and "=" or ""
      local others = #option > 1 and "(" .. table.concat(option, " ") .. ")" or ""
      local mark = option.repeats and "*" or others
      return ("%s'%s%s%s[%s]%s' \\\n"):format(indent, mark, name, assigned, zsh_text(option.text), value)
    end)
    return table.concat(lines)
  end))
end

local function zsh_block(command)
  local rest = command.words and ("'1:%s:(%s)'"):format(command.name, table.concat(command.words, " "):gsub(":", "\\:")) or "'*:file:_files'"
  return ("        %s) _arguments \\\n%s            %s && ret=0 ;;\n"):format(
    command.name, zsh_options(command.options, "            "), rest)
end

function scripts.zsh(program)
  return filled(zsh_template, {
    options = zsh_options(program.options, "    "),
    commands = table.concat(each(program.commands, function(command)
      return ("        '%s:%s'\n"):format(command.name, zsh_text(command.text))
    end)),
    blocks = table.concat(each(program.commands, zsh_block)),
  })
end

-- fish ---------------------------------------------------------------------------------------------------------------

local fish_template = [[
# Completion of meander for fish, written by `meander completion fish`.
complete -c meander -n __fish_use_subcommand -f -k -a '(__fish_complete_suffix .lua)'
]]

local fish_kinds = { folder = " -x -a '(__fish_complete_directories)'", file = " -r -F", module = " -r -F", text = " -x" }

local function fish_quoted(text) return "'" .. text:gsub("([\\'])", "\\%1") .. "'" end

local function fish_options(options, condition)
  return table.concat(each(options, function(option)
    local flags = each(option, function(name) return name:find "^%-%-" and "-l " .. name:sub(3) or "-s " .. name:sub(2) end)
    local value = option.words and (" -x -a '%s'"):format(table.concat(option.words, " ")) or fish_kinds[option.kind]
    return ("complete -c meander -n %s %s%s -d %s\n"):format(
      condition, table.concat(flags, " "), option.value and value or "", fish_quoted(option.text))
  end))
end

function scripts.fish(program)
  local text = fish_template .. fish_options(program.options, "__fish_use_subcommand")
  for _, command in ipairs(program.commands) do
    local condition = ("'__fish_seen_subcommand_from %s'"):format(command.name)
    text = text .. ("complete -c meander -n __fish_use_subcommand -f -a %s -d %s\n"):format(command.name, fish_quoted(command.text))
      .. fish_options(command.options, condition)
    if command.words then
      text = text .. ("complete -c meander -n %s -f -a '%s'\n"):format(condition, table.concat(command.words, " "))
    end
  end
  return text
end

return scripts

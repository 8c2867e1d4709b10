// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/man_page.hpp"

#include <fmt/format.h>

#include <array>

#include "app/command_line.hpp"
#include "app/subcommands.hpp"
#include "repl/commands.hpp"

namespace meander {
namespace {

struct Explained {
  const char* name;
  const char* text;
};

constexpr std::array kVariables = {
    Explained{"CLICOLOR_FORCE", "when set and not 0, colours even into a pipe"},
    Explained{"COLORTERM", "when truecolor or 24bit, the terminal has all colours"},
    Explained{"EDITOR", "what the prompt's .edit opens, where VISUAL is not set"},
    Explained{"HOME", "where the folders of XDG_CONFIG_HOME and XDG_STATE_HOME are when these are not set"},
    Explained{"MEANDER_DATA_DIR", "where the worlds and examples that come with the program are"},
    Explained{
        "MEANDER_GRAPHICS",
        "pictures in the terminal: kitty, sixel, half, truecolor, color256, ascii or none; found out when not set"},
    Explained{"NO_COLOR", "when not empty, no colours and no escape codes"},
    Explained{"PATH", "where .edit looks for the editor"},
    Explained{"STY", "when not empty, the terminal is screen: pictures are made of characters"},
    Explained{"TERM", "when dumb, plain text only"},
    Explained{"TMUX", "when not empty, the terminal is tmux: pictures are made of characters"},
    Explained{"VISUAL", "what the prompt's .edit opens"},
    Explained{"XDG_CONFIG_HOME", "where the start-up file is looked for, ~/.config when not set"},
    Explained{"XDG_STATE_HOME", "where the history is kept, ~/.local/state when not set"},
};

constexpr std::array kFiles = {
    Explained{"$XDG_CONFIG_HOME/meander/init.lua", "runs when the prompt starts; --no-rc skips it"},
    Explained{"$XDG_STATE_HOME/meander/history", "what was typed at the prompt"},
};

constexpr std::array kExamples = {
    Explained{"meander", "the prompt; help() says what there is"},
    Explained{"meander drive.lua --seed 3", "run a script; --seed 3 is for the script"},
    Explained{"meander -e 'print(meander.world.open \"worlds/office.toml\")'", "run a line of Lua"},
    Explained{"meander convert plan.png plan.toml", "make a world of a floor plan"},
    Explained{"meander doc sim:drive", "what a name means"},
};

/// roff: a backslash is an escape, a leading dot or quote a request, and a bare hyphen no minus.
std::string escaped(std::string_view text) {
  std::string result;
  bool at_start = true;
  for (const char c : text) {
    if (at_start && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\'')
      result += "\\(aq";
    else if (c == '"')
      result += "\\(dq";
    else if (c == '~')
      result += "\\(ti";
    else if (c == '^')
      result += "\\(ha";
    else
      result += c;
    at_start = c == '\n';
  }
  return result;
}

std::string section(const char* name) { return fmt::format(".SH {}\n", name); }
std::string entry(const std::string& tag, std::string_view text) {
  return ".TP\n.B " + escaped(tag) + "\n" + escaped(text) + "\n";
}
std::string preformatted(std::string_view text) { return ".nf\n" + escaped(text) + ".fi\n"; }

template <class Entries>
std::string entries(const Entries& table) {
  std::string text;
  for (const Explained& item : table) text += entry(item.name, item.text);
  return text;
}

std::string commands() {
  std::string text = section("COMMANDS");
  for (const Subcommand& command : subcommands())
    text += entry(fmt::format("meander {} {}", command.name, command.arguments), command.text);
  return text + ".PP\nEach tells its options with\n.BR \\-\\-help .\n";
}

std::string options() {
  std::string text = section("OPTIONS");
  for (const OptionText& option : option_texts()) text += entry(option.form, option.text);
  return text;
}

std::string lua(const script::Docs& docs) {
  std::string text =
      section("LUA") + escaped("Scripts are Lua 5.4 and see these modules; meander doc tells of each.\n");
  for (const script::Record& record : docs.all())
    if (record.kind == script::DocKind::module) text += entry(record.name(), record.text);
  return text;
}

std::string exit_status() {
  std::string text = section("EXIT STATUS");
  for (const ExitCode& code : exit_codes()) text += entry(std::to_string(code.code), code.text);
  return text;
}

constexpr const char* kHead = R"(.\" SPDX-License-Identifier: GPL-3.0-or-later
.\" SPDX-FileCopyrightText: the meander authors
.\" Written by meander doc \-\-write; changes here are lost.
.TH MEANDER 1 "" "meander )" MEANDER_VERSION R"("
.SH NAME
meander \- a laboratory for sonar navigation in a terminal
.SH SYNOPSIS
.B meander
.RI [ OPTIONS ]
.RI [ FILE
.RI [ ARGUMENTS... ]]
.br
.B meander
.I COMMAND
.RI [ ARGUMENTS... ]
.SH DESCRIPTION
Simulates robots that see nothing but sonar echoes; Lua edits their worlds, drives them and measures what they do, at a
prompt, in scripts and in tests.
.PP
.I FILE
and everything behind it belong to the script: its arguments are in the table
.B arg
and in
.BR ... .
A lone
.B \-
reads the script from standard input, and so does a call without
.I FILE
when standard input is not a terminal.
Without
.I FILE
and
.B \-e
at a terminal: the prompt.
)";

}  // namespace

std::string man_page(const script::Docs& docs) {
  return kHead + options() + commands() + section("PROMPT") + preformatted(repl::command_help()) + lua(docs) +
         exit_status() + section("ENVIRONMENT") + entries(kVariables) + section("FILES") + entries(kFiles) +
         section("EXAMPLES") + entries(kExamples);
}

}  // namespace meander

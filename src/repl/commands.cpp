// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace meander::repl {
namespace {

struct CommandHelp {
  const char* name;
  const char* argument;
  const char* text;
};

constexpr std::array kCommands = {
    CommandHelp{".help", "", "this text"},
    CommandHelp{".edit", "[FILE]", "change the last input, or a script, in $VISUAL or $EDITOR, and run it"},
    CommandHelp{".load", "FILE", "run a script here; its globals stay"},
    CommandHelp{".save", "FILE", "write what was typed and worked as a script"},
    CommandHelp{".timer", "on|off", "tell how long each input took"},
    CommandHelp{"?", "NAME", "what a name means: help \"NAME\""},
    CommandHelp{".quit", "", "leave, as Ctrl-D does"},
};

constexpr const char* kKeys = R"(
Type Lua. An expression shows its value, which is then in _ .
Modules are plain names: world, sim, ...
help() says what there is, help(x) what x is, apropos "word" what is about it.
Tab completes names and files; the arrow keys recall what was typed before,
Ctrl-R searches it. Ctrl-C stops whatever runs and keeps everything; Ctrl-D leaves.
)";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

}  // namespace

bool is_command(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('?')) return true;
  return line.size() > 1 && line[0] == '.' && std::isalpha(static_cast<unsigned char>(line[1]));
}

Command split_command(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('?')) return {"?", std::string(trimmed(line.substr(1)))};
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  return {std::string(line.substr(0, end)), std::string(trimmed(line.substr(end)))};
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const CommandHelp& command : kCommands) names.emplace_back(command.name);
  return names;
}

bool starts_command(std::string_view line) { return trimmed(line).starts_with('.'); }

script::Completion complete_command(std::string_view line) {
  const std::size_t start = line.find_last_of(" \t") + 1;
  script::Completion completion{.start = start};
  const std::string name = split_command(line).name;
  const bool names_command = trimmed(line.substr(0, start)).empty();
  if (names_command) completion.words = command_names();
  if (!names_command && name == ".timer") completion.words = {"off", "on"};
  completion.file_name = !names_command && (name == ".load" || name == ".save" || name == ".edit");
  std::erase_if(completion.words, [&](const std::string& word) { return !word.starts_with(line.substr(start)); });
  return completion;
}

std::string word_hint(std::string_view input, bool failed) {
  constexpr std::array kLeaving = {"exit", "quit", "bye", "q", "logout"};
  constexpr std::array kShell = {"ls", "dir", "pwd", "cd", "cat", "clear", "cls"};
  if (trimmed(input) == "help") return "help() tells what there is, help(x) what x is, .help the keys";
  std::string_view word = trimmed(input);
  if (word.ends_with("()")) word.remove_suffix(2);
  const auto is_one_of = [&](const auto& words) { return std::find(words.begin(), words.end(), word) != words.end(); };
  if (!failed) return {};
  if (is_one_of(kLeaving)) return ".quit or Ctrl-D leaves";
  if (is_one_of(kShell)) return "this is Lua, not a shell; Tab inside quotes completes names of files";
  return {};
}

std::string command_help() {
  std::string text;
  for (const CommandHelp& command : kCommands)
    text += fmt::format("  {:<6} {:<7} {}\n", command.name, command.argument, command.text);
  return text + kKeys;
}

}  // namespace meander::repl

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/subcommands.hpp"

#include <algorithm>
#include <array>

#include "app/batch.hpp"

namespace meander {
namespace {

constexpr std::array kSubcommands = {
    Subcommand{"convert", "IN OUT", "read a world or map, write it in another format",
               [](const CommandLine& line) { return run_lua_command("convert", line); }},
    Subcommand{"doc", "[NAME]", "what help(NAME) says; or the reference page, annotations, the man page", doc_command},
    Subcommand{"test", "PATH...", "run scripted tests: files, or all *_test.lua in folders", test_command},
    Subcommand{"completion", "SHELL", "print what a shell needs to complete the command line",
               [](const CommandLine& line) { return run_lua_command("completion", line); }},
};

}  // namespace

std::span<const Subcommand> subcommands() { return kSubcommands; }

std::vector<std::string> subcommand_names() {
  std::vector<std::string> names;
  for (const Subcommand& command : kSubcommands) names.emplace_back(command.name);
  return names;
}

const Subcommand* find_subcommand(std::string_view name) {
  const auto found = std::find_if(kSubcommands.begin(), kSubcommands.end(),
                                  [&](const Subcommand& command) { return command.name == name; });
  return found == kSubcommands.end() ? nullptr : &*found;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "script/sandbox.hpp"

namespace meander {

/// Exit codes of the program.
inline constexpr int kExitOk = 0;
inline constexpr int kExitScriptError = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitTestFailed = 3;
inline constexpr int kExitInterrupted = 130;

/// What one of them means, in words.
struct ExitCode {
  int code;
  const char* text;
};
std::span<const ExitCode> exit_codes();

/// What the user asked for.
struct CommandLine {
  std::vector<std::string> modules;  ///< -l
  std::vector<std::string> code;     ///< -e
  std::string lua_dir;
  std::optional<script::SandboxOptions> sandbox;  ///< --sandbox and the options that imply it
  std::optional<std::string> script;              ///< "-" is standard input
  std::vector<std::string> arguments;             ///< what follows the script
  bool interactive = false;                       ///< -i
  bool no_rc = false;
};

/// An option as people are told about it: "-l MODULE", "require MODULE before anything else".
struct OptionText {
  std::string form;
  std::string text;
};
std::vector<OptionText> option_texts();

/// Reads the command line. --help and --version print and give an exit code at once, as does a mistake.
std::optional<int> parse_command_line(int argc, char** argv, CommandLine& line);

}  // namespace meander

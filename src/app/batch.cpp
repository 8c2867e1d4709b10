// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/batch.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/confine.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"
#include "app/subcommands.hpp"
#include "base/data_folder.hpp"
#include "base/names.hpp"

namespace meander {
namespace {

using script::Interpreter;
using script::Outcome;

bool colors_refused() {
  const char* no_color = std::getenv("NO_COLOR");
  return no_color && *no_color;
}

int exit_code(const Outcome& outcome) {
  if (outcome.exit_code) return *outcome.exit_code;
  switch (outcome.kind) {
    case Outcome::Kind::done:
      return kExitOk;
    case Outcome::Kind::failed:
      return kExitScriptError;
    case Outcome::Kind::interrupted:
      return kExitInterrupted;
  }
  return kExitScriptError;
}

int run_script(Interpreter& lua, const std::string& path) {
  if (path == "-") return report(lua.run_input());
  const auto found = find_file(path);
  if (!found) {
    const std::string command = did_you_mean(path, subcommand_names());
    complain("no script '" + path + "'" + (command.empty() ? missing_file_hint(path) : command));
    return kExitUsage;
  }
  if (std::error_code error; std::filesystem::is_directory(*found, error)) {
    complain("'" + path + "' is a folder, a script expected");
    return kExitUsage;
  }
  return report(lua.run_main(*found));
}

}  // namespace

void set_up_terminal(Interpreter& lua) {
  lua.session().terminal = is_able_terminal(STDOUT_FILENO) && !colors_refused();
  lua.session().progress = progress_line();
}

int report(const Outcome& outcome) {
  if (outcome.kind == Outcome::Kind::interrupted)
    complain(outcome.message.empty() ? "interrupted" : outcome.message);
  else if (!outcome.done() && !outcome.exit_code)
    complain(script::text_of(outcome));
  return exit_code(outcome);
}

int run_batch(Interpreter& lua, const CommandLine& line) {
  lua.set_arguments(line.script.value_or("meander"), line.arguments);
  for (const std::string& module : line.modules)
    if (const int code = report(lua.load_module(module))) return code;
  for (const std::string& code : line.code)
    if (const int failed = report(lua.run_text(code, "=-e"))) return failed;
  return line.script ? run_script(lua, *line.script) : kExitOk;
}

int run_lua_command(const std::string& name, const CommandLine& line) {
  if (line.sandbox) confine(*line.sandbox, {line.lua_dir});
  Interpreter lua({.lua_dir = line.lua_dir, .sandbox = line.sandbox});
  set_up_terminal(lua);
  lua.set_arguments("meander " + name, line.arguments);
  return report(lua.run_text("require 'meander.commands." + name + "'", "=meander"));
}

}  // namespace meander

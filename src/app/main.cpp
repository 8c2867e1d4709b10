// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string_view>

#include "app/command_line.hpp"
#include "app/near_path.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"
#include "repl/prompt.hpp"
#include "script/interpreter.hpp"

namespace meander {
namespace {

using script::Interpreter;
using script::Outcome;

int exit_code(const Outcome& outcome) {
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

int report(const Outcome& outcome) {
  if (outcome.kind == Outcome::Kind::interrupted)
    complain(outcome.message.empty() ? "interrupted" : outcome.message);
  else if (!outcome.done())
    complain(script::text_of(outcome));
  return exit_code(outcome);
}

int run_script(Interpreter& lua, const std::string& path) {
  if (path == "-") return report(lua.run_input());
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    complain("no script '" + path + "'" + near_path_hint(path));
    return kExitUsage;
  }
  if (std::filesystem::is_directory(path, error)) {
    complain("'" + path + "' is a folder, a script expected");
    return kExitUsage;
  }
  return report(lua.run_main(path));
}

/// Everything but the prompt, in the order modules, code, script; stops at the first that fails.
int run_batch(Interpreter& lua, const CommandLine& line) {
  lua.set_arguments(line.script.value_or("meander"), line.arguments);
  for (const std::string& module : line.modules)
    if (const int code = report(lua.load_module(module))) return code;
  for (const std::string& code : line.code)
    if (const int failed = report(lua.run_text(code, "=-e"))) return failed;
  return line.script ? run_script(lua, *line.script) : kExitOk;
}

bool plain_terminal() {
  const char* term = std::getenv("TERM");
  const char* no_color = std::getenv("NO_COLOR");
  return !term || !*term || std::string_view(term) == "dumb" || (no_color && *no_color);
}

int run(CommandLine line) {
  const bool asks_for_nothing = !line.script && line.code.empty();
  if (asks_for_nothing && !line.interactive) {
    if (isatty(STDIN_FILENO))
      line.interactive = true;
    else
      line.script = "-";
  }
  Interpreter lua(line.lua_dir);
  lua.session().terminal = isatty(STDOUT_FILENO) && !plain_terminal();
  lua.session().progress = progress_line();
  const int code = run_batch(lua, line);
  if (!line.interactive) return code;
  return repl::run_prompt(lua, {.version = MEANDER_VERSION, .start_up = !line.no_rc});
}

}  // namespace
}  // namespace meander

int main(int argc, char** argv) {
  meander::guard_output();
  meander::CommandLine line;
  if (const auto code = meander::parse_command_line(argc, argv, line)) return *code;
  if (line.script == "test") {
    meander::complain(
        "scripted tests are not built yet; the test suite is './meander test' in a checkout, without paths");
    return meander::kExitUsage;
  }
  try {
    return meander::run(std::move(line));
  } catch (const std::exception& error) {
    meander::complain(error.what());
    return meander::kExitScriptError;
  }
}

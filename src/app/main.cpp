// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <fmt/format.h>
#include <unistd.h>

#include <exception>
#include <new>

#include "app/batch.hpp"
#include "app/command_line.hpp"
#include "app/confine.hpp"
#include "app/output.hpp"
#include "app/subcommands.hpp"
#include "repl/prompt.hpp"
#include "script/interpreter.hpp"

namespace meander {
namespace {

void tell_limits(const script::SandboxOptions& limits) {
  complain(fmt::format("sandbox: files of folder '{}' only, {} MiB of memory, {} s of computing time", limits.folder,
                       limits.memory, limits.seconds));
}

int run(CommandLine line) {
  if (line.script)
    if (const Subcommand* command = find_subcommand(*line.script)) return command->run(line);
  const bool asks_for_nothing = !line.script && line.code.empty();
  if (asks_for_nothing && !line.interactive) {
    if (isatty(STDIN_FILENO))
      line.interactive = true;
    else
      line.script.emplace("-");
  }
  if (line.sandbox) confine(*line.sandbox, {line.script.value_or(""), line.lua_dir});
  script::Interpreter lua({.lua_dir = line.lua_dir, .sandbox = line.sandbox});
  set_up_terminal(lua);
  const int code = run_batch(lua, line);
  if (!line.interactive || lua.ended()) return code;
  if (line.sandbox && isatty(STDIN_FILENO)) tell_limits(*line.sandbox);
  return repl::run_prompt(
      lua, {.version = MEANDER_VERSION, .start_up = !line.no_rc && !line.sandbox, .history = !line.sandbox});
}

}  // namespace
}  // namespace meander

int main(int argc, char** argv) {
  meander::guard_output();
  meander::CommandLine line;
  if (const auto code = meander::parse_command_line(argc, argv, line)) return *code;
  try {
    return meander::run(std::move(line));
  } catch (const std::bad_alloc&) {
    meander::complain("not enough memory");
    return meander::kExitScriptError;
  } catch (const std::exception& error) {
    meander::complain(error.what());
    return meander::kExitScriptError;
  }
}

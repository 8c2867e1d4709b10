// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/prompt.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "base/atomic_file.hpp"
#include "base/names.hpp"
#include "repl/commands.hpp"
#include "repl/error_text.hpp"
#include "repl/history.hpp"
#include "repl/line.hpp"
#include "repl/session_log.hpp"

namespace meander::repl {
namespace {

using script::Outcome;

class Prompt {
 public:
  explicit Prompt(script::Interpreter& lua)
      : lua_(lua),
        history_(history_path()),
        editor_([this](std::string_view text) { return complete(text); }, history_.entries()) {}

  void greet(const std::string& version) const;
  void start_up();
  void run();

 private:
  enum class Next { input, nothing, leave };

  Next read_input(std::string& text);
  void remember(const std::string& text);
  void evaluate(const std::string& text);
  bool obey(const std::string& line);
  void explain(const std::string& name);
  void load(const std::string& path);
  void save(const std::string& path);
  void set_timer(const std::string& argument);
  void report(const Outcome& outcome, const std::string& input) const;
  script::Completion complete(std::string_view text) const;
  static void say(const std::string& text);

  script::Interpreter& lua_;
  History history_;
  LineEditor editor_;
  SessionLog log_;
  std::string saved_path_;
  bool timer_ = false;
  bool history_works_ = true;
};

/// Messages go to stderr, behind all results so far.
void Prompt::say(const std::string& text) {
  std::fflush(stdout);
  fmt::print(stderr, "{}\n", text);
}

void Prompt::greet(const std::string& version) const {
  if (editor_.interactive()) say(fmt::format("meander {}, Lua 5.4. Try .help; Ctrl-D leaves.", version));
}

void Prompt::start_up() {
  const std::string path = start_up_path();
  std::error_code error;
  if (!path.empty() && std::filesystem::exists(path, error)) report(lua_.run_file(path), path);
}

void Prompt::run() {
  std::string text;
  for (Next next; (next = read_input(text)) != Next::leave;) {
    if (next == Next::nothing) continue;
    if (!is_command(text))
      evaluate(text);
    else if (!obey(text))
      return;
    std::fflush(stdout);
  }
}

/// One whole input: a command, or lines until they are complete Lua.
Prompt::Next Prompt::read_input(std::string& text) {
  text.clear();
  std::string line;
  do {
    switch (editor_.read(text.empty() ? "> " : ">> ", line)) {
      case LineEnd::interrupted:
        return Next::nothing;
      case LineEnd::end_of_input:
        return text.empty() ? Next::leave : Next::input;
      case LineEnd::entered:
        break;
    }
    if (text.empty() && is_command(line)) return remember(line), text = line, Next::input;
    text += (text.empty() ? "" : "\n") + line;
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) return Next::nothing;
  } while (lua_.incomplete(text));
  remember(text);
  return Next::input;
}

void Prompt::remember(const std::string& text) {
  if (!editor_.interactive()) return;
  editor_.remember(text);
  if (history_.add(text) || !history_works_) return;
  history_works_ = false;
  say("(this session is not kept in the history: '" + history_path() + "' cannot be written)");
}

void Prompt::report(const Outcome& outcome, const std::string& input) const {
  if (!outcome.done()) say(error_text(outcome, input));
}

void Prompt::evaluate(const std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = lua_.evaluate(text);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (!outcome.echo.empty()) fmt::print("{}\n", outcome.echo);
  report(outcome, text);
  if (outcome.done()) {
    log_.add({text, outcome.value, outcome.statement});
    if (declares_lost_local(text)) say("(a local ends with its line; without 'local' the value stays)");
  }
  if (timer_) say(fmt::format("({:.3f} s)", elapsed.count()));
}

/// False when the command ends the session.
bool Prompt::obey(const std::string& line) {
  const Command command = split_command(line);
  if (command.name == ".quit" || command.name == ".exit") return false;
  if (command.name == ".help")
    fmt::print("{}", command_help());
  else if (command.name == "?")
    explain(command.argument);
  else if (command.name == ".load")
    load(command.argument);
  else if (command.name == ".save")
    save(command.argument);
  else if (command.name == ".timer")
    set_timer(command.argument);
  else
    say(fmt::format("unknown command '{}'{} (.help lists them)", command.name,
                    did_you_mean(command.name, command_names())));
  return true;
}

void Prompt::explain(const std::string& name) {
  const std::string code = fmt::format("help({})", name.empty() ? "" : quoted(name));
  report(lua_.evaluate(code), code);
}

void Prompt::load(const std::string& path) {
  if (path.empty()) return say("which file? .load FILE");
  const Outcome outcome = lua_.run_file(path);
  report(outcome, path);
  if (outcome.done()) log_.add({fmt::format("dofile({})", quoted(path)), false, true});
}

void Prompt::save(const std::string& path) {
  if (path.empty()) return say("which file? .save FILE");
  if (log_.empty()) return say("nothing to save yet");
  std::error_code error;
  if (path != saved_path_ && std::filesystem::exists(path, error))
    return say("'" + path + "' exists already; choose another name");
  try {
    write_file_atomically(path, log_.script(lua_.plain_modules()));
    saved_path_ = path;
    say("saved as '" + path + "'");
  } catch (const FileError& failure) {
    say(failure.what());
  }
}

void Prompt::set_timer(const std::string& argument) {
  if (!argument.empty() && argument != "on" && argument != "off") return say("on or off? .timer on|off");
  timer_ = argument.empty() ? !timer_ : argument == "on";
  say(timer_ ? "(timer on)" : "(timer off)");
}

script::Completion Prompt::complete(std::string_view text) const {
  try {
    return lua_.complete(text);
  } catch (const std::exception&) {
    return {};  // readline is C code: nothing may fly through it
  }
}

}  // namespace

int run_prompt(script::Interpreter& lua, const PromptOptions& options) {
  lua.session().at_prompt = true;
  Prompt prompt(lua);
  prompt.greet(options.version);
  if (options.start_up) prompt.start_up();
  prompt.run();
  return 0;
}

}  // namespace meander::repl

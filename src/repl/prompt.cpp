// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/prompt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "base/atomic_file.hpp"
#include "base/data_folder.hpp"
#include "base/error.hpp"
#include "base/names.hpp"
#include "base/text_file.hpp"
#include "base/visible_text.hpp"
#include "repl/commands.hpp"
#include "repl/editor.hpp"
#include "repl/error_text.hpp"
#include "repl/history.hpp"
#include "repl/line.hpp"
#include "repl/session_log.hpp"
#include "script/help_text.hpp"

namespace meander::repl {
namespace {

using script::Outcome;

/// What a saved script lacks.
std::string left_out(std::size_t interrupted) {
  if (interrupted == 0) return {};
  return fmt::format(" ({} interrupted input{} left out; results may differ)", interrupted, interrupted > 1 ? "s" : "");
}

class Prompt {
 public:
  Prompt(script::Interpreter& lua, bool history)
      : lua_(lua),
        history_(history ? history_path() : std::string()),
        editor_([this](std::string_view text) { return complete(text); }, history_.entries()) {
    const auto& known = history_.entries();
    const auto lua_input = std::find_if_not(known.rbegin(), known.rend(), is_command);
    if (lua_input != known.rend()) last_input_ = *lua_input;
  }

  void greet(const std::string& version) const;
  void start_up();
  void run();

 private:
  enum class Next { input, nothing, leave };

  Next read_input(std::string& text);
  void remember(const std::string& text);
  bool perform(const std::string& text);
  void evaluate(const std::string& text);
  bool obey(const std::string& line);
  bool edit(const std::string& path);
  std::string edited_input() const;
  void edit_script(const std::string& path);
  void explain(const std::string& name);
  void load(const std::string& name);
  void save(const std::string& name);
  std::optional<std::string> permitted(const std::string& name, bool reads) const;
  void set_timer(const std::string& argument);
  void report(const Outcome& outcome, const std::string& input) const;
  void advise(const Outcome& outcome, const std::string& input) const;
  script::Completion complete(std::string_view text) const;
  script::Completion complete_question(std::string_view text) const;
  static void say(const std::string& text);

  script::Interpreter& lua_;
  History history_;
  LineEditor editor_;
  SessionLog log_;
  std::string last_input_;  ///< the newest that was Lua: what .edit edits
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
  if (editor_.interactive())
    say(fmt::format("meander {}, Lua 5.4. help() tells what there is, .help the keys; Ctrl-D leaves.", version));
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
    if (!perform(text) || lua_.ended()) return;
    std::fflush(stdout);
  }
}

/// False when it ends the session.
bool Prompt::perform(const std::string& text) {
  if (is_command(text)) return obey(text);
  evaluate(text);
  return true;
}

/// One whole input: a command, or lines until they are complete Lua.
Prompt::Next Prompt::read_input(std::string& text) {
  text.clear();
  std::string line;
  do {
    switch (editor_.read(text.empty() ? kPrompt : kContinuation, line)) {
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
  const bool behind_key = outcome.kind == Outcome::Kind::interrupted && editor_.interactive();  // the terminal wrote ^C
  if (!outcome.done()) say((behind_key ? "\n" : "") + error_text(outcome, input));
}

void Prompt::advise(const Outcome& outcome, const std::string& input) const {
  if (const std::string hint = word_hint(input, !outcome.done()); !hint.empty()) return say("(" + hint + ")");
  if (outcome.done() && declares_lost_local(input))
    say("(a local ends with its line; without 'local' the value stays)");
}

void Prompt::evaluate(const std::string& text) {
  last_input_ = text;
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = lua_.evaluate(text);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (!outcome.echo.empty()) fmt::print("{}\n", outcome.echo);
  report(outcome, text);
  advise(outcome, text);
  const bool interrupted = outcome.kind == Outcome::Kind::interrupted;
  if (outcome.done() || interrupted) log_.add({text, outcome.value, outcome.statement, interrupted});
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
  else if (command.name == ".edit")
    return edit(command.argument);
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

/// False when what was edited ends the session.
bool Prompt::edit(const std::string& path) {
  std::string text;
  try {
    if (!editor_.interactive()) fail<Error>(".edit needs a terminal");
    if (lua_.session().sandbox) fail<Error>("sandbox: no other programs, so no editor");
    if (!path.empty()) return edit_script(path), true;
    text = edited_input();
  } catch (const Error& failure) {
    say(failure.what());
  }
  if (text.empty()) return true;
  remember(text);
  return perform(text);
}

/// Shown as if it had been typed; empty where there is nothing to run.
std::string Prompt::edited_input() const {
  const std::string text = edit_text(last_input_);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return say("(empty: nothing to run)"), "";
  if (text == last_input_) return say("(unchanged: not run)"), "";
  std::string shown = kPrompt;
  for (const char c : visible_text(text)) shown += c == '\n' ? std::string("\n") + kContinuation : std::string(1, c);
  return say(shown), text;
}

void Prompt::edit_script(const std::string& path) {
  constexpr std::size_t kMostText = 16u << 20;
  std::error_code error;
  const std::string before = std::filesystem::exists(path, error) ? read_text_file(path, kMostText) : std::string();
  edit_file(path);
  if (!std::filesystem::exists(path, error)) return say("('" + path + "' was not written)");
  if (read_text_file(path, kMostText) == before) return say("(unchanged: not run; .load runs it)");
  load(path);
}

/// The path to use; says why, where a sandbox does not allow any.
std::optional<std::string> Prompt::permitted(const std::string& name, bool reads) const {
  try {
    return lua_.permitted_path(name, reads);
  } catch (const Error& refused) {
    say(refused.what());
    return std::nullopt;
  }
}

void Prompt::load(const std::string& name) {
  if (name.empty()) return say("which file? .load FILE");
  const auto path = permitted(name, true);
  if (!path) return;
  const auto found = find_file(*path);
  if (!found) return say("no script '" + name + "'" + missing_file_hint(*path));
  const Outcome outcome = lua_.run_file(*found);
  report(outcome, *found);
  if (outcome.done()) log_.add({fmt::format("dofile({})", quoted(*found)), false, true});
}

void Prompt::save(const std::string& name) {
  if (name.empty()) return say("which file? .save FILE");
  if (log_.empty()) return say("nothing to save yet");
  const std::string path = permitted(name, false).value_or("");
  if (path.empty()) return;
  std::error_code error;
  if (path != saved_path_ && std::filesystem::exists(path, error))
    return say("'" + path + "' exists already; choose another name");
  try {
    write_file_atomically(path, log_.script(lua_.declarations()));
    saved_path_ = path;
    say("saved as '" + path + "'" + left_out(log_.interrupted()));
  } catch (const FileError& failure) {
    say(failure.what());
  }
}

void Prompt::set_timer(const std::string& argument) {
  if (!argument.empty() && argument != "on" && argument != "off") return say("on or off? .timer on|off");
  timer_ = argument.empty() ? !timer_ : argument == "on";
  say(timer_ ? "(timer on)" : "(timer off)");
}

/// Whatever help knows, with and without "meander.".
script::Completion Prompt::complete_question(std::string_view text) const {
  const std::size_t start = std::min(text.find_first_not_of(" \t", 1), text.size());
  script::Completion completion{.start = start};
  for (std::string name : script::record_names(lua_.session().docs)) {
    if (name.starts_with(text.substr(start))) completion.words.push_back(name);
    if (constexpr std::string_view kLibrary = "meander."; name.starts_with(kLibrary)) name.erase(0, kLibrary.size());
    if (name.starts_with(text.substr(start))) completion.words.push_back(name);
  }
  std::sort(completion.words.begin(), completion.words.end());
  completion.words.erase(std::unique(completion.words.begin(), completion.words.end()), completion.words.end());
  return completion;
}

script::Completion Prompt::complete(std::string_view text) const {
  try {
    if (text.starts_with('?')) return complete_question(text);
    return starts_command(text) ? complete_command(text) : lua_.complete(text);
  } catch (const std::exception&) {
    return {};  // readline is C code: nothing may fly through it
  }
}

}  // namespace

int run_prompt(script::Interpreter& lua, const PromptOptions& options) {
  lua.session().at_prompt = true;
  Prompt prompt(lua, options.history);
  prompt.greet(options.version);
  if (options.start_up) prompt.start_up();
  prompt.run();
  return lua.ended() ? 1 : 0;
}

}  // namespace meander::repl

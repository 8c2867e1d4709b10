// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/completion.hpp"
#include "script/lua_traceback.hpp"
#include "script/sandbox.hpp"
#include "script/session.hpp"

namespace meander::script {

/// How a piece of Lua ended.
struct Outcome : ErrorReport {
  enum class Kind { done, failed, interrupted };
  Kind kind = Kind::done;
  std::string echo;              ///< of evaluate(): the values as text, empty where there are none
  std::optional<int> exit_code;  ///< that os.exit asked for in a sandbox: nothing runs any more
  bool value = false;            ///< of evaluate(): an expression
  bool statement = false;        ///< of evaluate(): could stand alone in a script; a call is both

  bool done() const { return kind == Kind::done; }
};

struct InterpreterOptions {
  std::string lua_dir{};  ///< folder of Lua modules to use instead of those inside the program; may be empty
  std::optional<SandboxOptions> sandbox{};  ///< limits for a script of somebody else
};

/// A Lua state with the standard libraries, strict globals, `meander`, and an interrupt. Scripts are texts: bytecode is
/// refused. math.random starts from the same seed in every run.
///
/// The first Ctrl-C ends what runs, with three exceptions where Lua runs no hooks: a message handler or a finalizer
/// that loops, and one long call into Lua's C library (a pattern, string.rep). The second one leaves the program at
/// once.
///
/// In a sandbox: libraries without what reaches other programs and files, texts only, limits of memory, instructions
/// and output. What protects the process is the program's to set up.
class Interpreter {
 public:
  explicit Interpreter(const InterpreterOptions& options = {});
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  Session& session() { return session_; }
  /// In a sandbox: a limit is used up, or the script has ended itself, and nothing will run any more.
  bool ended() const;
  /// For bindings beyond those of bind_all().
  lua_State* state() { return L_; }

  /// `script` and `arguments` become the global `arg`, as lua(1) has it; main scripts also get the arguments as `...`.
  void set_arguments(const std::string& script, const std::vector<std::string>& arguments);
  /// The path to use for a file that the user of the prompt names, as for one that a script names. Throws FileError
  /// where a sandbox does not allow it.
  std::string permitted_path(const std::string& name, bool reads) const;
  /// The main script: `require` looks beside it.
  Outcome run_main(const std::string& path);
  /// The main script from standard input.
  Outcome run_input();
  /// Any other script.
  Outcome run_file(const std::string& path);
  Outcome run_text(const std::string& code, const char* chunk);
  /// require(module), kept as a global named like the last part of the name.
  Outcome load_module(const std::string& module);

  /// True where `text` is the beginning of something: more lines must follow.
  bool incomplete(const std::string& text) const;
  /// Runs what was typed at the prompt. Expressions need no `return`; their first value is kept in `_`.
  Outcome evaluate(const std::string& text);
  /// What may stand at the end of `text`. Runs no code of the user.
  Completion complete(std::string_view text) const;
  /// The lines that a script must begin with to do what was typed at the prompt: "world = meander.world".
  std::vector<std::string> declarations() const;

 private:
  bool load(const std::string& code, const char* chunk);
  Outcome run_loaded(int arguments, bool echo = false);
  Outcome load_failure(const std::string& path = "input");
  int push_arguments();

  Session session_;
  lua_State* L_ = nullptr;
};

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "script/completion.hpp"

namespace meander::repl {

inline constexpr const char* kPrompt = "> ";
inline constexpr const char* kContinuation = ">> ";

enum class LineEnd { entered, interrupted, end_of_input };

/// Reads lines from the terminal with editing, history and completion, or plainly where standard input is none. The
/// only place that knows readline, of which there is one in a process.
class LineEditor {
 public:
  /// Asked for the end of the text left of the cursor; must not throw.
  using Completer = std::function<script::Completion(std::string_view text)>;

  LineEditor(Completer completer, const std::vector<std::string>& history);

  /// A pasted text of several lines comes as one. Ctrl-C gives up the line.
  LineEnd read(const std::string& prompt, std::string& line);
  /// Makes the entry the newest of the history.
  void remember(const std::string& entry);
  /// Standard input is a terminal.
  bool interactive() const { return interactive_; }

 private:
  LineEnd read_terminal(const std::string& prompt, std::string& line);

  bool interactive_;
};

}  // namespace meander::repl

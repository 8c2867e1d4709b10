// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace meander::repl {

/// The inputs of a session that worked, to be saved as a script that does the same again. Questions (help, apropos) do
/// nothing. What was interrupted may have done a part: it is named in a comment.
class SessionLog {
 public:
  struct Entry {
    std::string text;
    bool value = false;        ///< an expression
    bool statement = false;    ///< may stand alone in a script; a call is both
    bool interrupted = false;  ///< by Ctrl-C
  };

  void add(Entry entry);
  bool empty() const { return entries_.empty(); }
  std::size_t interrupted() const;
  /// The script begins with the lines of `declarations`: what only the prompt takes undeclared.
  std::string script(const std::vector<std::string>& declarations) const;

 private:
  bool last_value_used_after(std::size_t entry) const;

  std::vector<Entry> entries_;
};

}  // namespace meander::repl

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

namespace meander::repl {

/// The inputs of a session that worked, to be saved as a script that does the same again.
class SessionLog {
 public:
  struct Entry {
    std::string text;
    bool value = false;      ///< an expression
    bool statement = false;  ///< may stand alone in a script; a call is both
  };

  void add(Entry entry) { entries_.push_back(std::move(entry)); }
  bool empty() const { return entries_.empty(); }
  /// `modules` were used as plain names, which only the prompt knows: the script declares them first.
  std::string script(const std::vector<std::string>& modules) const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace meander::repl

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

namespace meander::repl {

/// What was typed, oldest first, without duplicates, in a file that only the user may read. Every entry is appended at
/// once, so that nothing is lost however the program ends, and several programs may share the file.
class History {
 public:
  static constexpr std::size_t kMost = 5000;

  /// Reads the file, if there is one. An empty path keeps everything in memory.
  explicit History(std::string path);

  const std::vector<std::string>& entries() const { return entries_; }
  /// Moves the entry to the end. An entry may have several lines. False when the file could not be written.
  bool add(const std::string& entry);

 private:
  void load();

  std::string path_;
  std::vector<std::string> entries_;
};

/// $XDG_STATE_HOME/meander/history, or below ~/.local/state; empty without a home.
std::string history_path();
/// $XDG_CONFIG_HOME/meander/init.lua, or below ~/.config; empty without a home.
std::string start_up_path();

}  // namespace meander::repl

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "render/frame.hpp"
#include "render/terminal.hpp"

namespace meander {

/// A moving picture on the alternate screen of a terminal, with a line of text below it. Writes only what changed, each
/// frame as one synchronised update. The terminal is as before when the screen is gone.
class Screen {
 public:
  /// What puts a terminal back from any moment of a live picture; for those who must leave in a hurry.
  static constexpr const char* kLeave = "\x1b[?2026l\x1b[0m\x1b[?25h\x1b[?1049l";

  explicit Screen(std::function<void(std::string_view)> write);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// How large a picture may be in a terminal of this size: the last row is the line's.
  static TerminalSize room(const TerminalSize& terminal);
  /// Shows the frame at the upper left, and the line, cut to the width of the terminal, in the row below it.
  void show(const Frame& frame, const std::string& line, const TerminalSize& terminal);
  /// Somebody else has written: everything is painted anew by the next show().
  void forget();

 private:
  std::string line_change(const std::string& line, int row) const;

  std::function<void(std::string_view)> write_;
  Frame shown_;
  std::string line_;
  TerminalSize terminal_{0, 0};
};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <termios.h>

#include <cstddef>
#include <optional>
#include <string_view>

#include "render/terminal.hpp"

namespace meander::script {

/// The size of the terminal behind standard output, if there is one.
std::optional<TerminalSize> window_size();

/// Characters in a line of text on standard output: as the terminal tells, else 80; 0 where there is no terminal.
std::size_t text_width();

/// The size of one character in pixels, as far as the terminal tells.
struct CellSize {
  int width = 10, height = 20;
};
CellSize cell_size();

/// Writes to standard output at once, behind everything written before. Signals do not cut it short.
void write_at_once(std::string_view text);

/// Standard output is a terminal, and the program may change its modes: it does not run in the background.
bool holds_terminal();

/// The terminal while a live picture is on it: keys are not echoed, and however the program is ended or stopped by a
/// signal, the terminal is put back before. One at a time.
class LiveTerminal {
 public:
  LiveTerminal();
  ~LiveTerminal();
  LiveTerminal(const LiveTerminal&) = delete;
  LiveTerminal& operator=(const LiveTerminal&) = delete;

  /// True once after the program was stopped (Ctrl-Z) and goes on: the picture is gone.
  bool resumed();
};

}  // namespace meander::script

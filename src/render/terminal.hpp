// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/fields.hpp"
#include "render/frame.hpp"

namespace meander {

struct TerminalSize {
  int columns = 80;
  int rows = 24;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TerminalSize>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"columns", "", "largest number of characters in a line", 1, 1000}, o.columns);
  visit(Field{"rows", "", "largest number of lines", 1, 1000}, o.rows);
}

/// The largest undistorted picture of the list within the size. Two pixels per character cell, one above the other; in
/// ascii mode one character per cell, chosen by what it shows. Walls, however thin, stay visible and one pixel wide.
Frame terminal_frame(const DrawList& list, const TerminalSize& size, TerminalMode mode);

/// What the characters of an ascii picture mean: "# wall   . path   @ robot".
std::string legend(const DrawList& list);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "render/draw_list.hpp"
#include "render/terminal_caps.hpp"

namespace meander {

inline constexpr char32_t kUpperHalf = 0x2580;  ///< upper half ink, lower half paper
inline constexpr char32_t kLowerHalf = 0x2584;

/// One character cell of a terminal.
struct Glyph {
  char32_t code = ' ';
  Color ink, paper;
  bool operator==(const Glyph&) const = default;
};

/// A rectangle of character cells, rows from the top.
struct Frame {
  int columns = 0;
  int rows = 0;
  TerminalMode mode = TerminalMode::ascii;  ///< ascii: colours have no meaning
  std::vector<Glyph> glyphs;

  Glyph& at(int column, int row) {
    return glyphs[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
  const Glyph& at(int column, int row) const { return const_cast<Frame*>(this)->at(column, row); }
  bool operator==(const Frame&) const = default;
};

/// The whole frame as lines of text, each ending in a line feed, colours reset before it. ASCII lines carry no escape
/// codes and no blanks at the end.
std::string text(const Frame& frame);

/// What turns a terminal that shows `before` into one that shows `after`: cursor moves, colours and changed characters
/// only, inside a synchronised update. Frames of another size or mode are painted anew. The frame's first cell is at
/// (left, top), counted from 1. Empty when nothing changed. In ascii mode cursor moves are the only escape codes.
std::string frame_difference(const Frame& before, const Frame& after, int left = 1, int top = 1);

/// The same without the synchronised update around it.
std::string frame_changes(const Frame& before, const Frame& after, int left = 1, int top = 1);

}  // namespace meander

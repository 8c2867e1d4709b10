// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/frame.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "render/unicode.hpp"

namespace meander {
namespace {

constexpr std::array<int, 6> kCube{0, 95, 135, 175, 215, 255};  ///< levels of xterm's colour cube

int nearest_level(int value) {
  int best = 0;
  for (int i = 1; i < 6; ++i)
    if (std::abs(kCube[static_cast<std::size_t>(i)] - value) < std::abs(kCube[static_cast<std::size_t>(best)] - value))
      best = i;
  return best;
}

/// xterm's number of the colour: 16 + cube, or one of the 24 greys 232 .. 255 when that is nearer.
int color256(Color c) {
  const int r = nearest_level(c.r), g = nearest_level(c.g), b = nearest_level(c.b);
  const int grey = std::min(23, std::max(0, ((c.r + c.g + c.b) / 3 - 3) / 10));
  const auto distance = [&](int x, int y, int z) {
    return (c.r - x) * (c.r - x) + (c.g - y) * (c.g - y) + (c.b - z) * (c.b - z);
  };
  const auto level = [](int i) { return kCube[static_cast<std::size_t>(i)]; };
  const int shade = 8 + 10 * grey;
  if (distance(shade, shade, shade) < distance(level(r), level(g), level(b))) return 232 + grey;
  return 16 + 36 * r + 6 * g + b;
}

/// Writes glyphs one after the other and knows which colours the terminal is set to.
class Pen {
 public:
  explicit Pen(TerminalMode mode) : mode_(mode) {}

  void put(const Glyph& glyph) {
    if (mode_ == TerminalMode::ascii) return append_utf8(out, glyph.code);
    const std::uint32_t ink = encoded(glyph.ink), paper = encoded(glyph.paper);
    if (glyph.code == ' ') {
      set(ink_, paper);
      out += ' ';
    } else if (glyph.code == kUpperHalf && cost(paper, ink) < cost(ink, paper)) {
      // The same picture upside down needs fewer colour changes.
      set(paper, ink);
      append_utf8(out, kLowerHalf);
    } else {
      set(ink, paper);
      append_utf8(out, glyph.code);
    }
  }

  void reset() {
    if (ink_ != kUnknown || paper_ != kUnknown) out += "\x1b[0m";
    ink_ = paper_ = kUnknown;
  }

  std::string out;

 private:
  static constexpr std::uint32_t kUnknown = 0xFFFFFFFF;

  std::uint32_t encoded(Color c) const {
    if (mode_ == TerminalMode::color256) return static_cast<std::uint32_t>(color256(c));
    return static_cast<std::uint32_t>(c.r) << 16 | static_cast<std::uint32_t>(c.g) << 8 | c.b;
  }

  int cost(std::uint32_t ink, std::uint32_t paper) const { return (ink != ink_) + (paper != paper_); }

  void append(const char* kind, std::uint32_t color) {
    if (mode_ == TerminalMode::color256)
      fmt::format_to(std::back_inserter(out), "{}8;5;{}", kind, color);
    else
      fmt::format_to(std::back_inserter(out), "{}8;2;{};{};{}", kind, color >> 16, color >> 8 & 255, color & 255);
  }

  void set(std::uint32_t ink, std::uint32_t paper) {
    if (cost(ink, paper) == 0) return;
    out += "\x1b[";
    if (ink != ink_) append("3", ink);
    if (ink != ink_ && paper != paper_) out += ';';
    if (paper != paper_) append("4", paper);
    out += 'm';
    ink_ = ink, paper_ = paper;
  }

  TerminalMode mode_;
  std::uint32_t ink_ = kUnknown;
  std::uint32_t paper_ = kUnknown;
};

}  // namespace

std::string text(const Frame& frame) {
  Pen pen(frame.mode);
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) pen.put(frame.at(column, row));
    pen.reset();
    if (frame.mode == TerminalMode::ascii) pen.out.erase(pen.out.find_last_not_of(' ') + 1);
    pen.out += '\n';
  }
  return pen.out;
}

std::string frame_changes(const Frame& before, const Frame& after, int left, int top) {
  const bool anew = before.columns != after.columns || before.rows != after.rows || before.mode != after.mode;
  Pen pen(after.mode);
  for (int row = 0; row < after.rows; ++row) {
    int cursor = -1;  // column the cursor stands at, -1: another row
    for (int column = 0; column < after.columns; ++column) {
      const Glyph& glyph = after.at(column, row);
      if (!anew && glyph == before.at(column, row)) continue;
      if (cursor < 0)
        fmt::format_to(std::back_inserter(pen.out), "\x1b[{};{}H", top + row, left + column);
      else if (cursor < column)
        fmt::format_to(std::back_inserter(pen.out), "\x1b[{}C", column - cursor);
      pen.put(glyph);
      cursor = column + 1;
    }
  }
  pen.reset();
  return pen.out;
}

std::string frame_difference(const Frame& before, const Frame& after, int left, int top) {
  const std::string changes = frame_changes(before, after, left, top);
  return changes.empty() ? changes : "\x1b[?2026h" + changes + "\x1b[?2026l";
}

}  // namespace meander

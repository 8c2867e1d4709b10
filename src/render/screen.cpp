// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/screen.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/unicode.hpp"

namespace meander {
namespace {

constexpr const char* kEnter = "\x1b[?1049h\x1b[?25l";
constexpr const char* kClear = "\x1b[0m\x1b[2J";
constexpr const char* kBegin = "\x1b[?2026h";
constexpr const char* kEnd = "\x1b[?2026l";

/// One row of text, without anything that could steer the terminal or wrap around.
std::string row_of(const std::string& text, int columns) {
  std::string row;
  int width = 0;
  for (const char32_t code : code_points(printable(text))) {
    if (++width > columns) break;
    append_utf8(row, is_narrow(code) ? code : U'?');
  }
  return row;
}

}  // namespace

Screen::Screen(std::function<void(std::string_view)> write) : write_(std::move(write)) { write_(kEnter); }

Screen::~Screen() { write_(kLeave); }

TerminalSize Screen::room(const TerminalSize& terminal) { return {terminal.columns, std::max(1, terminal.rows - 1)}; }

void Screen::forget() {
  write_(kEnter);
  terminal_ = {0, 0};
}

void Screen::show(const Frame& frame, const std::string& line, const TerminalSize& terminal) {
  std::string change;
  const bool anew = terminal.columns != terminal_.columns || terminal.rows != terminal_.rows ||
                    frame.columns != shown_.columns || frame.rows != shown_.rows;
  if (anew) {
    change = kClear;
    shown_ = {};
    line_.clear();
  }
  change += frame_changes(shown_, frame);
  if (terminal.rows > frame.rows) {
    const std::string row = row_of(line, terminal.columns);
    change += line_change(row, frame.rows + 1);
    line_ = row;
  }
  shown_ = frame;
  terminal_ = terminal;
  if (!change.empty()) write_(kBegin + change + kEnd);
}

/// From the first byte that differs on; the line is ASCII but for names, whose bytes are not split.
std::string Screen::line_change(const std::string& line, int row) const {
  if (line == line_) return {};
  auto same = static_cast<std::size_t>(std::mismatch(line.begin(), line.end(), line_.begin(), line_.end()).first -
                                       line.begin());
  const bool plain = std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c < 0x7F; });
  if (!plain) same = 0;
  return fmt::format("\x1b[{};{}H{}{}", row, same + 1, line.substr(same), line.size() < line_.size() ? "\x1b[K" : "");
}

}  // namespace meander

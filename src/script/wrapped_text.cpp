// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/wrapped_text.hpp"

#include <algorithm>

namespace meander::script {
namespace {

constexpr auto npos = std::string_view::npos;

/// A column that leaves less than half of the width is none.
std::size_t text_column(std::string_view line, std::size_t width) {
  const std::size_t first = line.find_first_not_of(' ');
  const std::size_t gap = line.find("  ", first);
  const std::size_t column = gap == npos ? npos : line.find_first_not_of(' ', gap);
  if (column != npos && column <= width / 2) return column;
  return first <= width / 2 ? first : 0;
}

void append_wrapped(std::string& text, std::string_view line, std::size_t width) {
  const std::size_t indent = text_column(line, width);
  std::size_t room = width, least = indent;
  while (line.size() > room) {
    std::size_t cut = line.rfind(' ', room);
    if (cut == npos || cut < least) cut = line.find(' ', room);
    if (cut == npos) break;
    text.append(line.substr(0, line.find_last_not_of(' ', cut) + 1)).append("\n").append(indent, ' ');
    line.remove_prefix(std::min(line.find_first_not_of(' ', cut), line.size()));
    room = width - indent;
    least = 1;
  }
  text += line;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
  if (width == 0) return std::string(text);
  std::string result;
  for (;;) {
    const std::size_t end = text.find('\n');
    append_wrapped(result, text.substr(0, end), width);
    if (end == npos) return result;
    result += '\n';
    text.remove_prefix(end + 1);
  }
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/test_text.hpp"

#include "base/visible_text.hpp"

namespace meander {
namespace {

/// A visible text with some characters written otherwise; `write` gives nullptr for those that stay.
template <class Write>
std::string rewritten(std::string_view text, Write write) {
  std::string result;
  for (const char c : visible_text(text)) {
    if (const char* other = write(c))
      result += other;
    else
      result += c;
  }
  return result;
}

}  // namespace

std::string one_line(std::string_view text) {
  return rewritten(text, [](char c) { return c == '\n' ? "\\n" : c == '\t' ? " " : nullptr; });
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : visible_text(text)) {
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

std::string xml_text(std::string_view text) {
  return rewritten(text, [](char c) -> const char* {
    switch (c) {
      case '<':
        return "&lt;";
      case '>':
        return "&gt;";
      case '&':
        return "&amp;";
      case '"':
        return "&quot;";
      case '\n':
        return "&#10;";
      case '\t':
        return "&#9;";
      default:
        return nullptr;
    }
  });
}

std::string yaml_text(std::string_view text) {
  const auto write = [](char c) {
    return c == '"' ? "\\\"" : c == '\\' ? "\\\\" : c == '\n' ? "\\n" : c == '\t' ? "\\t" : nullptr;
  };
  return '"' + rewritten(text, write) + '"';
}

}  // namespace meander

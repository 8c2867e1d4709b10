// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/error_text.hpp"

#include <string_view>

#include "base/visible_text.hpp"

namespace meander::repl {
namespace {

constexpr std::string_view kTyped = "prompt:";

/// "prompt:3: what" becomes "line 3: what", or "what".
std::string without_prompt_position(const std::string& text, bool one_line) {
  if (!text.starts_with(kTyped)) return text;
  const std::size_t end = text.find(": ", kTyped.size());
  if (end == std::string::npos) return text;
  return one_line ? text.substr(end + 2) : "line " + text.substr(kTyped.size());
}

bool says_only_typed(const std::string& frame) { return frame.starts_with(kTyped) && frame.ends_with("at top level"); }

}  // namespace

std::string error_text(const script::Outcome& outcome, const std::string& input) {
  const bool one_line = input.find('\n') == std::string::npos;
  script::ErrorReport shown;
  shown.message = without_prompt_position(outcome.message, one_line);
  if (outcome.kind == script::Outcome::Kind::interrupted) {
    const bool tells_where = outcome.message.ends_with(": interrupted") && !outcome.message.starts_with(kTyped);
    return tells_where ? visible_text(outcome.message) : "interrupted";
  }
  for (const std::string& frame : outcome.trace)
    if (!says_only_typed(frame)) shown.trace.push_back(without_prompt_position(frame, one_line));
  if (shown.trace.size() < 2) shown.trace.clear();
  return visible_text(text_of(shown));
}

bool declares_lost_local(const std::string& input) {
  const std::size_t start = input.find_first_not_of(" \t");
  return start != std::string::npos && input.compare(start, 6, "local ") == 0 &&
         input.find_first_of(";\n") == std::string::npos;
}

std::string quoted(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') literal += '\\';
    literal += c;
  }
  return literal + '"';
}

}  // namespace meander::repl

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/session_log.hpp"

#include <cctype>

namespace meander::repl {
namespace {

bool part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// `_` as a name of its own.
bool mentions_last_value(const std::string& text) {
  for (std::size_t at = text.find('_'); at != std::string::npos; at = text.find('_', at + 1)) {
    const bool starts = at == 0 || !part_of_name(text[at - 1]);
    const bool ends = at + 1 == text.size() || !part_of_name(text[at + 1]);
    if (starts && ends) return true;
  }
  return false;
}

}  // namespace

std::string SessionLog::script(const std::vector<std::string>& modules) const {
  std::string text;
  for (const std::string& module : modules) text += module + " = meander." + module + "\n";
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    const bool value_used = i + 1 < entries_.size() && mentions_last_value(entries_[i + 1].text);
    if (value_used && entry.value)
      text += "_ = " + entry.text + "\n";
    else if (entry.value && !entry.statement)
      text += "print(" + entry.text + ")\n";
    else
      text += entry.text + "\n";
  }
  return text;
}

}  // namespace meander::repl

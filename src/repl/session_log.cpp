// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/session_log.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace meander::repl {
namespace {

bool part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// `for _, x in` and `local _` make a `_` of their own.
bool declares(std::string_view before, std::string_view after) {
  const auto skip = [](std::string_view text) { return text.find_first_not_of(" \t\n"); };
  before = before.substr(0, before.find_last_not_of(" \t\n") + 1);
  after.remove_prefix(std::min(skip(after), after.size()));
  return before.ends_with("for") || before.ends_with("local") || after.starts_with("in ");
}

/// `_` as a name of its own, to be read.
bool mentions_last_value(std::string_view text) {
  for (std::size_t at = text.find('_'); at != std::string_view::npos; at = text.find('_', at + 1)) {
    const bool starts = at == 0 || !part_of_name(text[at - 1]);
    const bool ends = at + 1 == text.size() || !part_of_name(text[at + 1]);
    if (starts && ends && !declares(text.substr(0, at), text.substr(at + 1))) return true;
  }
  return false;
}

bool is_question(const SessionLog::Entry& entry) {
  const auto end = std::find_if_not(entry.text.begin(), entry.text.end(), part_of_name);
  const std::string first(entry.text.begin(), end);
  return entry.value && (first == "help" || first == "apropos");
}

std::string as_comment(const std::string& text) {
  std::string comment = "-- interrupted, left out; results may differ: ";
  for (const char c : text) comment += c == '\n' ? std::string("\n--   ") : std::string(1, c);
  return comment + "\n";
}

}  // namespace

void SessionLog::add(Entry entry) {
  if (!is_question(entry)) entries_.push_back(std::move(entry));
}

std::size_t SessionLog::interrupted() const {
  return static_cast<std::size_t>(
      std::count_if(entries_.begin(), entries_.end(), [](const Entry& e) { return e.interrupted; }));
}

/// Is `_` read before the next value takes its place?
bool SessionLog::last_value_used_after(std::size_t entry) const {
  for (std::size_t i = entry + 1; i < entries_.size(); ++i) {
    if (entries_[i].interrupted) continue;
    if (mentions_last_value(entries_[i].text)) return true;
    if (entries_[i].value) return false;
  }
  return false;
}

std::string SessionLog::script(const std::vector<std::string>& declarations) const {
  std::string text;
  for (const std::string& line : declarations) text += line + "\n";
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    const bool value_used = entry.value && last_value_used_after(i);
    if (entry.interrupted)
      text += as_comment(entry.text);
    else if (value_used && entry.text != "_")
      text += "_ = " + entry.text + "\n" + (entry.statement ? "" : "print(_)\n");
    else if (entry.value && !entry.statement)
      text += "print(" + entry.text + ")\n";
    else
      text += entry.text + "\n";
  }
  return text;
}

}  // namespace meander::repl

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_yaml.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

class FlatYaml {
 public:
  FlatYaml(std::string_view text, const std::string& name) : text_(text), name_(name) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);  // byte order mark
  }

  std::vector<YamlEntry> read() {
    for (skip_gap(); !at_end() && !starts("..."); skip_gap()) {
      if (starts("---")) {
        if (!entries_.empty()) complain("a second document in one file is not understood");
        at_ += 3;
        end_line();
        continue;
      }
      if (column() != 0) complain("a key in the first column expected; nested values are not understood");
      entries_.push_back(entry());
    }
    return std::move(entries_);
  }

 private:
  bool at_end() const { return at_ >= text_.size(); }
  char here() const { return at_end() ? '\n' : text_[at_]; }
  bool starts(std::string_view mark) const { return text_.substr(at_).starts_with(mark) && column() == 0; }
  std::size_t column() const {
    const std::size_t before = at_ == 0 ? std::string_view::npos : text_.rfind('\n', at_ - 1);
    return before == std::string_view::npos ? at_ : at_ - before - 1;
  }

  template <class... Args>
  [[noreturn]] void complain(fmt::format_string<Args...> format, Args&&... args) const {
    fail<FileError>("{}:{}: {}", name_, line_, fmt::format(format, std::forward<Args>(args)...));
  }

  [[noreturn]] void complain_of_no_value(const YamlEntry& entry) const {
    if (!at_end() && column() != 0) complain("a key in the first column expected; nested values are not understood");
    fail<FileError>("{}:{}: key '{}': a value expected", name_, entry.line, printable(entry.key));
  }

  void skip_blanks() {
    while (!at_end() && is_blank(text_[at_])) ++at_;
  }

  /// A comment needs a blank in front of it, or the start of the line.
  bool at_comment() const { return here() == '#' && (at_ == 0 || is_blank(text_[at_ - 1]) || text_[at_ - 1] == '\n'); }

  /// Blanks, comments and empty lines.
  void skip_gap() {
    for (skip_blanks(); !at_end() && (text_[at_] == '\n' || at_comment()); skip_blanks()) {
      at_ = std::min(text_.find('\n', at_), text_.size());
      if (at_end()) return;
      ++at_;
      ++line_;
    }
  }

  void end_line() {
    skip_blanks();
    if (here() != '\n' && !at_comment()) complain("the end of the line expected, got '{}'", printable(rest_of_line()));
  }

  std::string_view rest_of_line() const { return text_.substr(at_, text_.find('\n', at_) - at_); }

  YamlEntry entry() {
    YamlEntry entry;
    entry.line = line_;
    entry.key = here() == '"' || here() == '\'' ? quoted() : plain(":");
    skip_blanks();
    if (entry.key.empty() || here() != ':') complain("'key: value' expected, got '{}'", printable(entry.key));
    ++at_;
    if (here() != '\n' && !is_blank(here())) complain("a blank expected after '{}:'", printable(entry.key));
    for (const YamlEntry& other : entries_)
      if (other.key == entry.key) complain("key '{}' comes twice, first in line {}", printable(entry.key), other.line);
    skip_blanks();
    if (here() == '[') {
      entry.list = true;
      flow_list(entry.values);
    } else if (here() == '\n' || at_comment()) {
      entry.list = true;
      block_list(entry.values);
      if (entry.values.empty()) complain_of_no_value(entry);
      return entry;
    } else {
      entry.values.push_back(scalar(""));
    }
    end_line();
    return entry;
  }

  /// [a, b, c], over several lines if need be.
  void flow_list(std::vector<std::string>& values) {
    ++at_;
    for (;;) {
      skip_gap();
      if (here() == ']') break;
      values.push_back(scalar(",]"));
      skip_gap();
      if (here() == ',')
        ++at_;
      else if (here() != ']')
        complain("',' or ']' expected in a list");
    }
    ++at_;
  }

  void block_list(std::vector<std::string>& values) {
    for (skip_gap(); here() == '-' && !starts("---"); skip_gap()) {
      ++at_;
      if (!is_blank(here())) complain("a blank and a value expected after '-'");
      skip_blanks();
      values.push_back(scalar(""));
      end_line();
    }
  }

  std::string scalar(std::string_view stops) {
    if (here() == '"' || here() == '\'') return quoted();
    if (std::string_view("&*!|>{}[]%@`,").find(here()) != std::string_view::npos)
      complain("a plain or quoted value expected, got '{}'", printable(rest_of_line()));
    std::string value = plain(stops);
    if (value.empty()) complain("a value expected");
    if (value.find(": ") != std::string::npos || value.ends_with(':'))
      complain("a single value expected, got '{}'; quote it if it is one", printable(value));
    return value;
  }

  std::string plain(std::string_view stops) {
    const std::size_t first = at_;
    while (here() != '\n' && !at_comment() && stops.find(here()) == std::string_view::npos) ++at_;
    std::string_view value = text_.substr(first, at_ - first);
    while (!value.empty() && is_blank(value.back())) value.remove_suffix(1);
    return std::string(value);
  }

  std::string quoted() {
    const char mark = text_[at_++];
    std::string value;
    for (;; ++at_) {
      if (here() == '\n') complain("{} expected at the end of a quoted value", mark);
      if (here() == mark) {
        ++at_;
        if (mark == '"' || here() != '\'') return value;  // '' in single quotes is one '
      } else if (mark == '"' && here() == '\\') {
        ++at_;
        value += escaped(here());
        continue;
      }
      value += here();
    }
  }

  char escaped(char c) const {
    switch (c) {
      case 'n':
        return '\n';
      case 't':
        return '\t';
      case '\\':
      case '"':
      case '/':
        return c;
      default:
        complain("the escape '\\{}' is not understood", printable(std::string(1, c)));
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<YamlEntry> entries_;
};

}  // namespace

std::vector<YamlEntry> flat_yaml(std::string_view text, const std::string& name) { return FlatYaml(text, name).read(); }

std::string yaml_scalar(const std::string& text) {
  const auto harmless = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '/';
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), harmless)) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n')
      quoted += "\\n";
    else
      quoted += c;
  }
  return quoted + '"';
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/visible_text.hpp"

namespace meander {

/// The lines of a text file as words; its complaints name file and line.
class TextLines {
 public:
  TextLines(std::string_view text, std::string path) : text_(text), path_(std::move(path)) {}

  /// Reads the next line that is not empty into words(); false at the end.
  bool next() {
    do {
      if (text_.empty()) return words_.clear(), false;
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      split(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
    } while (words_.empty());
    return true;
  }
  const std::vector<std::string_view>& words() const { return words_; }
  bool is(std::string_view word) const { return !words_.empty() && words_[0] == word; }
  /// Fails unless the line has so many words.
  void count(std::size_t words, const char* form) const {
    if (words_.size() != words) wrong("'{}' expected", form);
  }

  double number(std::size_t word) const {
    const double value = parsed<double>(word, "a number");
    if (!std::isfinite(value)) wrong("a finite number expected, got '{}'", shown(word));
    return value;
  }
  template <class Integer = int>
  Integer integer(std::size_t word, Integer least, Integer most) const {
    const Integer value = parsed<Integer>(word, "a whole number");
    if (value < least || value > most) wrong("a whole number from {} to {} expected, got {}", least, most, value);
    return value;
  }
  std::string shown(std::size_t word) const { return visible_text(words_.at(word).substr(0, 40)); }

  template <class... Args>
  [[noreturn]] void wrong(fmt::format_string<Args...> format, Args&&... args) const {
    fail<FileError>("{}:{}: {}", path_, line_, fmt::format(format, std::forward<Args>(args)...));
  }

 private:
  void split(std::string_view line) {
    words_.clear();
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t begin = line.find_first_not_of(" \t\r", i);
      if (begin == std::string_view::npos) return;
      i = std::min(line.find_first_of(" \t\r", begin), line.size());
      words_.push_back(line.substr(begin, i - begin));
    }
  }
  template <class T>
  T parsed(std::size_t word, const char* what) const {
    const std::string_view text = words_.at(word);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) wrong("{} expected, got '{}'", what, shown(word));
    return value;
  }

  std::string_view text_;
  std::string path_;
  int line_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace meander

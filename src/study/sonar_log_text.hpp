// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "study/sonar_log.hpp"
#include "world/text.hpp"

namespace meander {

/// The lines of a text, without what ends them and without the mark that some editors put before UTF-8.
class LogLines {
 public:
  LogLines(std::string_view text, const Work& work) : rest_(text), work_(work) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }
  bool next() {
    if (rest_.empty()) return false;
    if (++number_ % 1000 == 0) work_.poll();
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    while (!line_.empty() && (line_.back() == '\r' || line_.back() == ' ')) line_.remove_suffix(1);
    return true;
  }
  std::string_view line() const { return line_; }
  int number() const { return number_; }

 private:
  std::string_view rest_, line_;
  const Work& work_;
  int number_ = 0;
};

/// The whole word as a number; "nan" and "inf" are numbers, too.
inline std::optional<double> number_in(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// Counts a record that cannot be right, or refuses it: FileError "name:line: what".
class BadRecordCounter {
 public:
  BadRecordCounter(const std::string& name, BadRecords bad) : name_(name), bad_(bad) {}
  void operator()(int& counter, int line, const std::string& what) const {
    if (bad_ == BadRecords::refuse) fail<FileError>("{}:{}: {}", name_, line, what);
    ++counter;
  }

 private:
  std::string name_;
  BadRecords bad_;
};

/// A range as robots see it: impossible ones count, and become no echo.
inline double checked_range(double range, int line, const SonarLogOptions& options, const BadRecordCounter& bad,
                            SonarLogReport& report) {
  if (range >= 0 && range <= options.range_possible) return range < options.range_max ? range : options.range_max;
  bad(report.bad_ranges, line, fmt::format("a range from 0 to {} m expected, got {}", options.range_possible, range));
  return options.range_max;
}

}  // namespace meander

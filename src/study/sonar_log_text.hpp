// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

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

/// From there on doubles do not tell the cycles of a robot apart [s].
constexpr double kNoTime = 1e15;

/// When something was recorded, and where that stands.
struct Stamp {
  double time;
  int line;
};

/// Which records to keep so that as many as possible are in order: one that is far off is left out, never what follows
/// it. Of two that exclude each other the later goes.
inline std::vector<bool> longest_in_order(const std::vector<Stamp>& stamps) {
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> first;  // first[n]: of the chains of n + 1 records the one that begins latest
  std::vector<std::size_t> next(stamps.size(), kNone);
  for (std::size_t i = stamps.size(); i-- > 0;) {
    const auto at = std::partition_point(first.begin(), first.end(),
                                         [&](std::size_t k) { return stamps[k].time >= stamps[i].time; });
    if (at != first.begin()) next[i] = *(at - 1);
    if (at == first.end())
      first.push_back(i);
    else
      *at = i;
  }
  std::vector<bool> keep(stamps.size());
  for (std::size_t i = first.empty() ? kNone : first.back(); i != kNone; i = next[i]) keep[i] = true;
  return keep;
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

/// Which records are in order; the others count, and are told after which or before which record they cannot be.
inline std::vector<bool> in_order(const std::vector<Stamp>& stamps, const BadRecordCounter& bad,
                                  SonarLogReport& report) {
  const std::vector<bool> keep = longest_in_order(stamps);
  std::size_t last = stamps.size(), next = 0;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const auto [time, line] = stamps[i];
    if (keep[i]) last = i;
    for (next = std::max(next, i); next < stamps.size() && !keep[next]; ++next) {
    }
    if (keep[i]) continue;
    if (last < i && time < stamps[last].time)
      bad(report.out_of_order, line,
          fmt::format("time {} is before that of the last record, {}", time, stamps[last].time));
    else
      bad(report.out_of_order, line,
          fmt::format("time {} is after that of the next record, {}", time, stamps[next].time));
  }
  return keep;
}

/// A range as robots see it: impossible ones count, and become no echo.
inline double checked_range(double range, int line, const SonarLogOptions& options, const BadRecordCounter& bad,
                            SonarLogReport& report) {
  if (range >= 0 && range <= options.range_possible) return range < options.range_max ? range : options.range_max;
  bad(report.bad_ranges, line, fmt::format("a range from 0 to {} m expected, got {}", options.range_possible, range));
  return options.range_max;
}

}  // namespace meander

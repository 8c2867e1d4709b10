// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/sonar_log.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/text_file.hpp"
#include "study/sonar_log_text.hpp"

namespace meander {
namespace {

constexpr std::size_t kLargestLog = std::size_t{1} << 30;  ///< [bytes]

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t end = std::min(line.find(',', from), line.size());
    std::string_view cell = line.substr(from, end - from);
    while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
    while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
    cells.push_back(cell);
    from = end + 1;
  }
  return cells;
}

struct Columns {
  std::size_t count = 0, time = 0, x = 0, y = 0, heading = 0;
  std::vector<std::size_t> ranges, whiskers, lights;
};

using Prefixes = std::initializer_list<std::string_view>;

/// The number in a name like "sonar_7" or "s7".
std::optional<unsigned> number_behind(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  unsigned number = 0;
  const std::string_view digits = name.substr(prefix.size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

/// The columns of a ring in the order of their numbers, which begin at 0 or 1: a gap or a column too many would turn
/// the ring, and nothing could tell that from the map.
std::vector<std::size_t> ring_columns(const std::vector<std::string_view>& names, Prefixes prefixes,
                                      const std::string& file) {
  std::map<unsigned, std::size_t> by_number;
  std::string_view prefix;
  for (const std::string_view one : prefixes)
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto number = number_behind(one, names[i]);
      if (!number) continue;
      if (!by_number.empty() && one != prefix)
        fail<FileError>("{}:1: columns of one ring expected, got '{}' and '{}'", file,
                        printable(names[by_number.begin()->second]), printable(names[i]));
      prefix = one;
      if (!by_number.emplace(*number, i).second)
        fail<FileError>("{}:1: column '{}{}' is there twice", file, prefix, *number);
    }
  std::vector<std::size_t> columns;
  unsigned expected = by_number.contains(0) ? 0 : 1;
  for (const auto& [number, at] : by_number) {
    if (number != expected) fail<FileError>("{}:1: column '{}{}' is missing", file, prefix, expected);
    ++expected;
    columns.push_back(at);
  }
  return columns;
}

Columns columns_of(std::string_view head, const std::string& name) {
  const auto names = split(head);
  const auto find = [&](std::initializer_list<std::string_view> wanted) {
    for (const std::string_view one : wanted) {
      const auto at = std::find(names.begin(), names.end(), one);
      if (at == names.end()) continue;
      if (std::find(at + 1, names.end(), one) != names.end())
        fail<FileError>("{}:1: column '{}' is there twice", name, one);
      return static_cast<std::size_t>(at - names.begin());
    }
    fail<FileError>("{}:1: no column '{}' in the head line '{}'", name, *wanted.begin(), printable(head));
  };
  const bool odometry = std::find(names.begin(), names.end(), "odometry_x") != names.end();
  Columns columns{names.size(), find({"time"}), 0, 0, 0, {}, {}, {}};
  columns.x = odometry ? find({"odometry_x"}) : find({"x"});
  columns.y = odometry ? find({"odometry_y"}) : find({"y"});
  columns.heading = odometry ? find({"odometry_heading"}) : find({"heading", "theta"});
  columns.ranges = ring_columns(names, {"sonar_", "sonar", "s", "S"}, name);
  columns.whiskers = ring_columns(names, {"whisker_"}, name);
  columns.lights = ring_columns(names, {"light_"}, name);
  if (columns.ranges.empty() && columns.whiskers.empty() && columns.lights.empty())
    fail<FileError>("{}:1: no columns 'sonar_0', 'sonar_1', ... in the head line", name);
  return columns;
}

std::optional<std::vector<double>> numbers_at(const std::vector<std::string_view>& cells, const Columns& columns) {
  if (cells.size() != columns.count) return std::nullopt;
  std::vector<double> numbers;
  const auto take = [&](std::size_t at) {
    const auto number = number_in(cells[at]);
    if (number) numbers.push_back(*number);
    return number.has_value();
  };
  for (const std::size_t at : {columns.time, columns.x, columns.y, columns.heading})
    if (!take(at) || !std::isfinite(numbers.back())) return std::nullopt;
  if (std::abs(numbers.front()) >= kNoTime) return std::nullopt;
  for (const std::size_t at : columns.ranges)
    if (!take(at)) return std::nullopt;
  for (const auto* ring : {&columns.whiskers, &columns.lights})
    for (const std::size_t at : *ring)
      if (!take(at) || !std::isfinite(numbers.back())) return std::nullopt;
  return numbers;
}

/// The numbers of all records that have them, and when they are from.
struct Rows {
  std::vector<std::vector<double>> numbers;
  std::vector<Stamp> stamps;
};

Rows rows_of(LogLines& lines, const Columns& columns, const BadRecordCounter& bad, SonarLogReport& report) {
  Rows rows;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    auto numbers = numbers_at(split(lines.line()), columns);
    if (!numbers) {
      bad(report.short_records, lines.number(),
          fmt::format("{} columns with numbers for time, pose and {} ranges expected, got '{}'", columns.count,
                      columns.ranges.size(), printable(lines.line())));
      continue;
    }
    rows.stamps.push_back({numbers->front(), lines.number()});
    rows.numbers.push_back(std::move(*numbers));
  }
  return rows;
}

}  // namespace

SonarLog sonar_log_from_csv(const std::string& text, const std::string& name, const SonarLogOptions& options,
                            const Work& work) {
  validate(options);
  SonarLog log;
  LogLines lines(text, work);
  const BadRecordCounter bad(name, options.bad);
  if (!lines.next()) fail<FileError>("{}:1: a head line expected, got nothing", name);
  const Columns columns = columns_of(lines.line(), name);
  log.sonars = static_cast<int>(columns.ranges.size());
  Rows rows = rows_of(lines, columns, bad, log.report);
  const std::vector<bool> keep = in_order(rows.stamps, bad, log.report);
  for (std::size_t row = 0; row < keep.size(); ++row) {
    if (!keep[row]) continue;
    const std::vector<double> numbers = std::move(rows.numbers[row]);
    Observation scan;
    scan.time = numbers[0];
    scan.period = log.scans.empty() ? 0 : scan.time - log.scans.back().time;
    scan.odometry.pose = {numbers[1], numbers[2], wrap_angle(numbers[3])};
    auto next = numbers.begin() + 4;
    for (std::size_t i = 0; i < columns.ranges.size(); ++i)
      scan.readings.sonar.push_back(checked_range(*next++, rows.stamps[row].line, options, bad, log.report));
    for (std::size_t i = 0; i < columns.whiskers.size(); ++i) scan.readings.whisker.push_back(*next++ != 0);
    scan.readings.light.assign(next, numbers.end());
    scan.readings.sonar_max = options.range_max;
    scan.readings.sonar_pose.assign(scan.readings.sonar.size(), scan.odometry.pose);
    log.scans.push_back(std::move(scan));
  }
  log.report.lines = lines.number();
  log.report.scans = static_cast<int>(log.scans.size());
  return log;
}

SonarLog read_sonar_log(const std::string& path, const SonarLogOptions& options, const Work& work) {
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (suffix == ".csv") return sonar_log_from_csv(read_text_file(path, kLargestLog), path, options, work);
  if (suffix == ".log" || suffix == ".clf" || suffix == ".carmen")
    return sonar_log_from_carmen(read_text_file(path, kLargestLog), path, options, work);
  fail<FileError>("{}: a log with the suffix .csv, .log, .clf or .carmen expected", path);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/test_report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string_view>

#include "app/output.hpp"
#include "app/test_text.hpp"

namespace meander {
namespace {

using Kind = script::TestOutcome::Kind;

std::string points_text(const PlannedTest& planned) {
  const double points = planned.test.points;
  return points > 0 ? fmt::format(" [{:g} point{}]", points, points == 1 ? "" : "s") : std::string();
}

void print_indented(std::string_view margin, const std::vector<std::string>& lines, std::size_t from = 0) {
  for (std::size_t i = from; i < lines.size(); ++i) fmt::print("{}{}\n", margin, lines[i]);
}

void print_output(const TestRecord& record) { print_indented("  | ", lines_of(record.output)); }

/// "demo_test.lua:12: name: what" and, indented below, the rest.
void print_failure(const TestRecord& record) {
  const std::vector<std::string> text = lines_of(record.outcome.text);
  fmt::print("{}: {}{}: {}\n", one_line(record.outcome.place), one_line(record.planned.test.name()),
             points_text(record.planned), text.empty() ? std::string("failed") : text[0]);
  print_indented("  ", text, 1);
  for (const std::string& frame : record.outcome.trace) print_indented("  ", lines_of(frame));
  print_output(record);
}

class HumanReport {
 public:
  explicit HumanReport(bool verbose) : verbose_(verbose), dots_(!verbose && is_able_terminal(STDERR_FILENO)) {}

  void add(const TestRecord& record) {
    const Kind kind = record.outcome.kind;
    if (kind == Kind::failed) {
      end_dots();
      print_failure(record);
    } else if (verbose_) {
      print_verbose(record);
    }
    std::fflush(stdout);
    if (!dots_ || kind == Kind::failed) return;
    std::fputc(kind == Kind::passed ? '.' : 's', stderr);
    ++column_;
  }

  void end(const TestCount& count) {
    end_dots();
    if (count.points_in_all > 0) fmt::print("{:g} of {:g} points\n", count.points, count.points_in_all);
    fmt::print("{}\n", count.text());
    std::fflush(stdout);
  }

 private:
  void print_verbose(const TestRecord& record) {
    const std::string name = one_line(record.planned.test.name()) + points_text(record.planned);
    if (record.outcome.kind == Kind::skipped)
      fmt::print("skipped {}: {}\n", name, one_line(record.outcome.text));
    else
      fmt::print("ok      {} ({:.2f} s)\n", name, record.seconds);
    print_output(record);
  }

  void end_dots() {
    if (column_ > 0) std::fputc('\n', stderr);
    column_ = 0;
  }

  bool verbose_;
  bool dots_;
  int column_ = 0;
};

class TapReport {
 public:
  void begin(std::size_t planned) {
    fmt::print("TAP version 13\n1..{}\n", planned);
    std::fflush(stdout);
  }

  void add(const TestRecord& record) {
    const bool failed = record.outcome.kind == Kind::failed;
    fmt::print("{} {}{}{}\n", failed ? "not ok" : "ok", ++number_, description(record),
               record.outcome.kind == Kind::skipped ? " # SKIP " + one_line(record.outcome.text) : "");
    if (failed) print_yaml(record);
    std::fflush(stdout);
  }

  void end(const TestCount& count) {
    if (count.points_in_all > 0) fmt::print("# {:g} of {:g} points\n", count.points, count.points_in_all);
    fmt::print("# {}\n", count.text());
    std::fflush(stdout);
  }

 private:
  /// A # would begin a directive.
  static std::string description(const TestRecord& record) {
    std::string text;
    for (const char c : one_line(record.planned.test.name())) text += c == '#' ? std::string("\\#") : std::string(1, c);
    return text.empty() ? text : " - " + text;
  }

  static void print_list(const char* key, const std::vector<std::string>& lines) {
    if (lines.empty()) return;
    fmt::print("  {}:\n", key);
    for (const std::string& line : lines) fmt::print("    - {}\n", yaml_text(line));
  }

  static void print_yaml(const TestRecord& record) {
    fmt::print("  ---\n  message: {}\n  severity: fail\n  at: {}\n  duration_ms: {:.0f}\n",
               yaml_text(record.outcome.text), yaml_text(record.outcome.place), 1000 * record.seconds);
    if (record.planned.test.points > 0) fmt::print("  points: {:g}\n", record.planned.test.points);
    print_list("trace", record.outcome.trace);
    print_list("output", lines_of(record.output));
    fmt::print("  ...\n");
  }

  std::size_t number_ = 0;
};

template <class Report>
TestReport report_of(std::shared_ptr<Report> report) {
  return {.begin = {},
          .add = [report](const TestRecord& record) { report->add(record); },
          .end = [report](const TestCount& count) { report->end(count); }};
}

}  // namespace

void TestCount::add(const TestRecord& record) {
  const Kind kind = record.outcome.kind;
  ++(kind == Kind::passed ? passed : kind == Kind::failed ? failed : skipped);
  points_in_all += record.planned.test.points;
  if (kind == Kind::passed) points += record.planned.test.points;
}

std::string TestCount::text() const {
  std::string text = fmt::format("{} passed, {} failed", passed, failed);
  if (skipped > 0) text += fmt::format(", {} skipped", skipped);
  return text;
}

TestReport human_report(bool verbose) { return report_of(std::make_shared<HumanReport>(verbose)); }

TestReport tap_report() {
  const auto tap = std::make_shared<TapReport>();
  TestReport report = report_of(tap);
  report.begin = [tap](std::size_t planned) { tap->begin(planned); };
  return report;
}

}  // namespace meander

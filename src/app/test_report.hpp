// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/test_run.hpp"

namespace meander {

struct TestCount {
  std::size_t passed = 0, failed = 0, skipped = 0;
  double points = 0, points_in_all = 0;

  void add(const TestRecord& record);
  /// "3 passed, 1 failed, 2 skipped".
  std::string text() const;
};

/// Tells on standard output how a run of tests goes.
struct TestReport {
  std::function<void(std::size_t planned)> begin;
  std::function<void(const TestRecord& record)> add;
  std::function<void(const TestCount& count)> end;
};

/// For people: failures, with file and line first; `verbose`: every test. Dots on the terminal behind stderr.
TestReport human_report(bool verbose);
/// The Test Anything Protocol, version 13, with a YAML block below each failure.
TestReport tap_report();

/// The JUnit XML that continuous integration reads.
std::string junit_text(const std::vector<TestRecord>& records);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/work.hpp"
#include "script/test_suite.hpp"

namespace meander {

/// What `meander test` was asked for.
struct TestOptions {
  std::vector<std::string> paths;
  std::vector<std::string> arguments;  ///< behind --
  std::string filter;                  ///< only tests whose name contains it
  std::int64_t seed = 1;
  int jobs = 0;         ///< at a time; 0: one per core
  double timeout = 60;  ///< [s]
  bool fail_fast = false;
  bool list = false;
  bool tap = false;
  bool verbose = false;
  std::string junit;  ///< file to write
  script::InterpreterOptions interpreter;
};

/// A test that is to run, or a file that could not be loaded: that one fails at once.
struct PlannedTest {
  std::string file;
  script::TestCase test;
  std::size_t index = 0;  ///< in its file
  std::optional<script::TestOutcome> outcome;
  std::string output;  ///< of a file that could not be loaded
};

struct TestRecord {
  PlannedTest planned;
  script::TestOutcome outcome;
  double seconds = 0;
  std::string output;
};

/// Loads the files and lists what is to run, in the order of the files and in them of their lines. nullopt: stopped.
std::optional<std::vector<PlannedTest>> plan_tests(const TestOptions& options, const std::vector<std::string>& files,
                                                   const StopToken& stop);

/// Runs them, each in a process and Lua state of its own. `take` gets the records in the order of the plan. True when
/// all were run.
bool run_tests(const TestOptions& options, const std::vector<PlannedTest>& plan, const StopToken& stop,
               const std::function<void(const TestRecord&)>& take);

}  // namespace meander

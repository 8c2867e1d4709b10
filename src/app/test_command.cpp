// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "app/output.hpp"
#include "app/subcommands.hpp"
#include "app/test_files.hpp"
#include "app/test_options.hpp"
#include "app/test_report.hpp"
#include "app/test_text.hpp"
#include "base/atomic_file.hpp"
#include "base/names.hpp"

namespace meander {
namespace {

StopToken interrupted;  // what a signal handler can reach

/// The tests run in process groups of their own: Ctrl-C comes here alone. Where it is ignored, it stays so.
void listen_for_interrupt() {
  struct sigaction action {};
  sigaction(SIGINT, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = [](int) { interrupted.request(); };
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

int nothing_to_run(const TestOptions& options, bool any_file) {
  if (!any_file)
    complain(fmt::format("no test found: no file *_test.lua in '{}'", listing(options.paths, 5)));
  else
    complain(fmt::format("no test whose name contains '{}'; --list names them all", options.filter));
  return kExitUsage;
}

int list_names(const std::vector<PlannedTest>& plan) {
  bool broken = false;
  for (const PlannedTest& planned : plan) {
    if (planned.outcome) {
      complain(fmt::format("{}: {}", planned.outcome->place, planned.outcome->text));
      broken = true;
    } else {
      fmt::print("{}:{}: {}\n", one_line(planned.file), planned.test.line, one_line(planned.test.name()));
    }
  }
  return broken ? kExitTestFailed : kExitOk;
}

struct Results {
  TestCount count;
  std::vector<TestRecord> records;
};

Results run(const TestOptions& options, const std::vector<PlannedTest>& plan) {
  const TestReport report = options.tap ? tap_report() : human_report(options.verbose);
  Results results;
  if (report.begin) report.begin(plan.size());
  run_tests(options, plan, interrupted, [&](const TestRecord& record) {
    results.count.add(record);
    report.add(record);
    if (!options.junit.empty()) results.records.push_back(record);
  });
  report.end(results.count);
  return results;
}

int exit_code(const Results& results, std::size_t planned) {
  const std::size_t left = planned - results.count.passed - results.count.failed - results.count.skipped;
  if (interrupted.requested()) {
    complain(fmt::format("interrupted; {} test{} not run", left, left == 1 ? "" : "s"));
    return kExitInterrupted;
  }
  if (left > 0) complain(fmt::format("stopped at the first failure; {} test{} not run", left, left == 1 ? "" : "s"));
  return results.count.failed > 0 ? kExitTestFailed : kExitOk;
}

}  // namespace

int test_command(const CommandLine& line) {
  TestOptions options;
  if (const auto code = parse_test_options(line, options)) return *code;
  std::vector<std::string> files;
  try {
    files = test_files(options.paths);
    if (options.interpreter.sandbox) check_inside(options.paths, options.interpreter.sandbox->folder);
    if (!options.junit.empty()) check_writable(options.junit);
  } catch (const FileError& error) {
    complain(error.what());
    return kExitUsage;
  }
  if (files.empty()) return nothing_to_run(options, false);
  listen_for_interrupt();
  const auto plan = plan_tests(options, files, interrupted);
  if (!plan) {
    complain("interrupted while loading the tests");
    return kExitInterrupted;
  }
  if (plan->empty()) return nothing_to_run(options, true);
  if (options.list) return list_names(*plan);
  const Results results = run(options, *plan);
  if (!options.junit.empty()) write_file_atomically(options.junit, junit_text(results.records));
  return exit_code(results, plan->size());
}

}  // namespace meander

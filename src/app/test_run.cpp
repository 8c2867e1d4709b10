// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/test_run.hpp"

#include <algorithm>
#include <filesystem>
#include <thread>

#include "app/confine.hpp"
#include "app/test_jobs.hpp"

namespace meander {
namespace {

using script::Interpreter;
using script::TestCase;
using script::TestFile;
using script::TestOutcome;

std::size_t job_count(const TestOptions& options) {
  return options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : std::max(1u, std::thread::hardware_concurrency());
}

TestFile test_file(const TestOptions& options, const std::string& path) {
  return {path, options.arguments, options.seed};
}

/// For a child: walls around it, for good. A file may read what lies beside it.
void settle(const TestOptions& options, const std::string& path) {
  const auto& sandbox = options.interpreter.sandbox;
  if (!sandbox) return;
  const std::string folder = std::filesystem::path(path).parent_path().string();
  confine(*sandbox, {path, folder, options.interpreter.lua_dir});
}

/// Why a process has no result to show.
TestOutcome failure(const TestJobEnd& end, const std::string& file, double timeout) {
  TestOutcome outcome = script::failure_at(end.result.text, file);
  if (end.timed_out) {
    outcome.text = fmt::format("timed out after {:g} s", timeout);
  } else if (end.result.died) {
    outcome.text = "ended without a result: " + end.result.text;
  }
  return outcome;
}

PlannedTest broken_file(const std::string& file, TestOutcome outcome, std::string output) {
  PlannedTest broken;
  broken.file = file;
  broken.test.path = {"loading"};
  broken.outcome = std::move(outcome);
  broken.output = std::move(output);
  return broken;
}

void plan_file(const TestOptions& options, const std::string& file, const TestJobEnd& end,
               std::vector<PlannedTest>& plan) {
  try {
    if (!end.result.ok || end.timed_out) {
      plan.push_back(broken_file(file, failure(end, file, options.timeout), end.output));
      return;
    }
    const std::vector<TestCase> tests = script::test_cases_from(end.result.text);
    if (tests.empty()) {
      const TestOutcome empty{TestOutcome::Kind::failed, file, "there is no test in it", {}};
      plan.push_back(broken_file(file, empty, end.output));
    }
    for (std::size_t i = 0; i < tests.size(); ++i)
      if (tests[i].name().find(options.filter) != std::string::npos)
        plan.push_back({file, tests[i], i, std::nullopt, {}});
  } catch (const Error& error) {
    plan.push_back(broken_file(file, {TestOutcome::Kind::failed, file, error.what(), {}}, end.output));
  }
}

double timeout_of(const TestOptions& options, const TestCase& test) {
  return test.timeout > 0 ? test.timeout : options.timeout;
}

TestJob job_of(const TestOptions& options, const PlannedTest& planned) {
  return {[&options, &planned] {
            settle(options, planned.file);
            Interpreter lua(options.interpreter);
            return script::run_test(lua, test_file(options, planned.file), planned.index, planned.test.name());
          },
          timeout_of(options, planned.test)};
}

std::string line_of(const PlannedTest& planned) { return fmt::format("{}:{}", planned.file, planned.test.line); }

TestOutcome outcome_of(const TestOptions& options, const PlannedTest& planned, const TestJobEnd& end) {
  TestOutcome outcome;
  try {
    outcome = end.result.ok ? script::test_outcome_from(end.result.text)
                            : failure(end, planned.file, timeout_of(options, planned.test));
  } catch (const Error& error) {
    outcome.text = error.what();
  }
  if (end.timed_out) {
    outcome.kind = TestOutcome::Kind::failed;
    outcome.text = fmt::format("timed out after {:g} s", timeout_of(options, planned.test));
  }
  if (outcome.place.empty()) outcome.place = line_of(planned);
  return outcome;
}

/// What is known of a test without running it.
std::optional<TestRecord> known_record(const PlannedTest& planned) {
  if (planned.outcome) return TestRecord{planned, *planned.outcome, 0, planned.output};
  if (planned.test.skip.empty()) return std::nullopt;
  return TestRecord{planned, {TestOutcome::Kind::skipped, line_of(planned), planned.test.skip, {}}, 0, {}};
}

}  // namespace

std::optional<std::vector<PlannedTest>> plan_tests(const TestOptions& options, const std::vector<std::string>& files,
                                                   const StopToken& stop) {
  std::vector<TestJob> jobs;
  for (const std::string& path : files)
    jobs.push_back({[&options, &path] {
                      settle(options, path);
                      Interpreter lua(options.interpreter);
                      return script::list_tests(lua, test_file(options, path));
                    },
                    options.timeout});
  std::vector<PlannedTest> plan;
  const bool complete = run_test_jobs(jobs, job_count(options), stop, [&](std::size_t index, const TestJobEnd& end) {
    plan_file(options, files[index], end, plan);
    return true;
  });
  if (!complete) return std::nullopt;
  return plan;
}

bool run_tests(const TestOptions& options, const std::vector<PlannedTest>& plan, const StopToken& stop,
               const std::function<void(const TestRecord&)>& take) {
  std::vector<TestJob> jobs;
  for (const PlannedTest& planned : plan)
    if (!known_record(planned)) jobs.push_back(job_of(options, planned));
  auto next = plan.begin();
  bool enough = false;
  const auto give = [&](const TestRecord& record) {
    take(record);
    ++next;
    enough = options.fail_fast && record.outcome.kind == TestOutcome::Kind::failed;
    return !enough;
  };
  const auto give_known = [&] {
    for (; next != plan.end() && !enough;) {
      const auto record = known_record(*next);
      if (!record || !give(*record)) break;
    }
    return !enough;
  };
  if (!give_known()) return false;
  return run_test_jobs(jobs, job_count(options), stop, [&](std::size_t, const TestJobEnd& end) {
    return give({*next, outcome_of(options, *next, end), end.seconds, end.output}) && give_known();
  });
}

}  // namespace meander

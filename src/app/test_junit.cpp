// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <fmt/format.h>

#include <map>

#include "app/test_report.hpp"
#include "app/test_text.hpp"

namespace meander {
namespace {

using Kind = script::TestOutcome::Kind;

/// One file: its tests are one suite.
struct Suite {
  std::string cases;
  TestCount count;
  double seconds = 0;

  std::size_t tests() const { return count.passed + count.failed + count.skipped; }
};

std::string details(const TestRecord& record) {
  std::string text = record.outcome.place + ": " + record.outcome.text;
  for (const std::string& frame : record.outcome.trace) text += "\n  " + frame;
  return text;
}

/// The groups of a test with dots between, behind the file.
std::string class_name(const PlannedTest& planned) {
  std::string name = planned.file;
  for (std::size_t i = 0; i + 1 < planned.test.path.size(); ++i) name += "." + planned.test.path[i];
  return name;
}

std::string test_case(const TestRecord& record) {
  const PlannedTest& planned = record.planned;
  std::string text = fmt::format(R"(    <testcase name="{}" classname="{}" file="{}" line="{}" time="{:.3f}">)",
                                 xml_text(planned.test.path.back()), xml_text(class_name(planned)),
                                 xml_text(planned.file), planned.test.line, record.seconds) +
                     "\n";
  if (planned.test.points > 0)
    text +=
        fmt::format("      <properties><property name=\"points\" value=\"{:g}\"/></properties>\n", planned.test.points);
  if (record.outcome.kind == Kind::skipped)
    text += fmt::format("      <skipped message=\"{}\"/>\n", xml_text(record.outcome.text));
  if (record.outcome.kind == Kind::failed)
    text += fmt::format("      <failure message=\"{}\">{}</failure>\n", xml_text(record.outcome.text),
                        xml_text(details(record)));
  if (!record.output.empty()) text += fmt::format("      <system-out>{}</system-out>\n", xml_text(record.output));
  return text + "    </testcase>\n";
}

std::string figures(const Suite& suite) {
  return fmt::format(R"(tests="{}" failures="{}" errors="0" skipped="{}" time="{:.3f}")", suite.tests(),
                     suite.count.failed, suite.count.skipped, suite.seconds);
}

}  // namespace

std::string junit_text(const std::vector<TestRecord>& records) {
  std::map<std::string, Suite> suites;
  Suite all;
  for (const TestRecord& record : records)
    for (Suite* suite : {&suites[record.planned.file], &all}) {
      suite->count.add(record);
      suite->seconds += record.seconds;
      if (suite != &all) suite->cases += test_case(record);
    }
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"meander\" {}>\n", figures(all));
  for (const auto& [file, suite] : suites)
    text +=
        fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", xml_text(file), figures(suite), suite.cases);
  return text + "</testsuites>\n";
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/test_suite.hpp"

#include <lauxlib.h>
#include <lua.h>

#include <nlohmann/json.hpp>

#include "script/lua_interrupt.hpp"
#include "script/pack.hpp"

namespace meander::script {
namespace {

using Json = nlohmann::json;

/// Pushes meander.testing.`name`.
void push_testing(lua_State* L, const char* name) {
  lua_getglobal(L, "require");
  lua_pushliteral(L, "meander.testing");
  lua_call(L, 1, 1);
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
}

/// Argument 1 is the seed.
int install(lua_State* L) {
  push_testing(L, "install");
  lua_pushvalue(L, 1);
  lua_call(L, 1, 0);
  return 0;
}

/// Gives what meander.testing[argument 1] returns for argument 2.
int ask(lua_State* L) {
  push_testing(L, lua_tostring(L, 1));
  lua_pushvalue(L, 2);
  lua_call(L, 1, 1);
  return 1;
}

/// Calls meander.testing.`what`(number) and leaves the result on the stack. Its errors are mistakes of the program.
void ask(lua_State* L, const char* what, std::size_t number = 0) {
  ErrorReport report;
  lua_pushcfunction(L, ask);
  lua_pushstring(L, what);
  lua_pushinteger(L, static_cast<lua_Integer>(number));
  if (!call_reporting(L, 2, report)) fail<Error>("{}", report.message);
}

/// Leaves the list of the file's tests on the stack.
void load(Interpreter& lua, const TestFile& file) {
  lua_State* L = lua.state();
  ErrorReport report;
  lua_pushcfunction(L, install);
  lua_pushinteger(L, static_cast<lua_Integer>(file.seed));
  if (!call_reporting(L, 1, report)) fail<Error>("{}", report.message);
  lua.set_arguments(file.path, file.arguments);
  if (const Outcome outcome = lua.run_main(file.path); !outcome.done()) fail<Error>("{}", text_of(outcome));
  ask(L, "list");
}

/// An empty Lua table is an empty list.
std::string text_at(const Json& table, const char* key) {
  return table.is_object() ? table.value(key, std::string()) : std::string();
}

TestCase test_case_from(const Json& table) {
  TestCase test;
  for (const Json& part : table.at("path")) test.path.push_back(part.get<std::string>());
  test.line = table.at("line").get<int>();
  test.skip = text_at(table, "skip");
  test.points = table.value("points", 0.0);
  test.timeout = table.value("timeout", 0.0);
  return test;
}

std::vector<TestCase> cases_from(const Json& list) {
  std::vector<TestCase> cases;
  for (const Json& table : list) cases.push_back(test_case_from(table));
  return cases;
}

/// Whatever nlohmann has to say about bytes of another kind.
template <class Read>
auto reading(Read read) {
  try {
    return read();
  } catch (const Json::exception& error) {
    fail<Error>("an answer that cannot be read: {}", error.what());
  }
}

std::string bytes_of(const TestOutcome& outcome) {
  const std::vector<std::uint8_t> bytes = Json::to_cbor(Json{{"kind", static_cast<int>(outcome.kind)},
                                                             {"place", outcome.place},
                                                             {"text", outcome.text},
                                                             {"trace", outcome.trace}});
  return {bytes.begin(), bytes.end()};
}

TestOutcome failure(const ErrorReport& report, const std::string& path) {
  TestOutcome outcome = failure_at(report.message, path);
  outcome.trace = report.trace;
  return outcome;
}

/// Runs the test and what comes after it. Where both fail, the first failure is told.
TestOutcome run_body(lua_State* L, Session& session, const std::string& path, std::size_t index) {
  TestOutcome outcome{.kind = TestOutcome::Kind::passed};
  const InterruptScope scope(L, session.stop);
  for (const char* part : {"body", "cleanup"}) {
    if (session.stop.requested()) break;
    ask(L, part, index + 1);
    ErrorReport report;
    if (!call_reporting(L, 0, report) && outcome.kind == TestOutcome::Kind::passed) outcome = failure(report, path);
  }
  return outcome;
}

/// What the test says of itself overrules how it ended: a pcall may have swallowed the error.
void apply_verdict(TestOutcome& outcome, const Json& verdict, const std::string& path) {
  if (const std::string exited = text_at(verdict, "exited"); !exited.empty()) {
    outcome = failure_at(exited, path);
  } else if (const std::string skip = text_at(verdict, "skip"); !skip.empty()) {
    outcome = {.kind = TestOutcome::Kind::skipped, .text = skip};
  } else if (const std::string idle = text_at(verdict, "idle");
             !idle.empty() && outcome.kind == TestOutcome::Kind::passed) {
    outcome = failure_at(idle, path);
  }
}

Json pop_json(lua_State* L) {
  const std::string bytes = pack(L, -1);
  lua_pop(L, 1);
  return Json::from_cbor(bytes);
}

}  // namespace

std::string TestCase::name() const {
  std::string name;
  for (const std::string& part : path) name += (name.empty() ? "" : " ") + part;
  return name;
}

std::string list_tests(Interpreter& lua, const TestFile& file) {
  load(lua, file);
  return pack(lua.state(), -1);
}

std::string run_test(Interpreter& lua, const TestFile& file, std::size_t index, const std::string& name) {
  load(lua, file);
  lua_State* L = lua.state();
  const std::vector<TestCase> tests = cases_from(pop_json(L));
  if (index >= tests.size() || tests[index].name() != name)
    fail<Error>("{}: the file defines other tests each time it is loaded", file.path);
  TestOutcome outcome = run_body(L, lua.session(), file.path, index);
  ask(L, "verdict");
  apply_verdict(outcome, pop_json(L), file.path);
  return bytes_of(outcome);
}

std::vector<TestCase> test_cases_from(const std::string& bytes) {
  return reading([&] { return cases_from(Json::from_cbor(bytes)); });
}

TestOutcome test_outcome_from(const std::string& bytes) {
  return reading([&] {
    const Json table = Json::from_cbor(bytes);
    return TestOutcome{.kind = static_cast<TestOutcome::Kind>(table.at("kind").get<int>()),
                       .place = table.at("place").get<std::string>(),
                       .text = table.at("text").get<std::string>(),
                       .trace = table.at("trace").get<std::vector<std::string>>()};
  });
}

TestOutcome failure_at(const std::string& message, const std::string& path) {
  TestOutcome outcome{.kind = TestOutcome::Kind::failed, .text = message};
  const std::size_t colon = message.find(": ");
  if (colon == std::string::npos) return outcome;
  const std::size_t digits = message.find_last_not_of("0123456789", colon - 1);
  const bool positioned = digits != std::string::npos && digits > 0 && digits + 1 < colon && message[digits] == ':';
  if (!positioned) return outcome;
  std::string file = message.substr(0, digits);
  if (file.starts_with("...") && path.ends_with(file.substr(3))) file = path;
  outcome.place = file + message.substr(digits, colon - digits);
  outcome.text = message.substr(colon + 2);
  return outcome;
}

}  // namespace meander::script

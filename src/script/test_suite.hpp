// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "script/interpreter.hpp"

namespace meander::script {

/// A test file and what its tests are given.
struct TestFile {
  std::string path;
  std::vector<std::string> arguments;  ///< the table `arg` of the file
  std::int64_t seed = 1;
};

/// One test of a file, as the file defines it.
struct TestCase {
  std::vector<std::string> path;  ///< the groups it is in, outermost first, and its own name
  int line = 0;
  std::string skip;    ///< why it is not run; empty: it is
  double points = 0;   ///< what passing it is worth
  double timeout = 0;  ///< [s]; 0: the usual one

  /// The parts of the path with blanks between: "editing a world undoes a removal".
  std::string name() const;
};

/// How one test ended.
struct TestOutcome {
  enum class Kind { passed, failed, skipped };
  Kind kind = Kind::failed;
  std::string place{};  ///< "demo_test.lua:12"; may be empty
  std::string text{};   ///< why it failed or was skipped
  std::vector<std::string> trace{};
};

// Each of the following wants a fresh interpreter, best in a process of its own, and answers in bytes that another
// process can read.

/// Loads the file and lists its tests. Throws Error with the script position when the file cannot be loaded.
std::string list_tests(Interpreter& lua, const TestFile& file);
/// Loads the file and runs its test number `index`, which must have this name.
std::string run_test(Interpreter& lua, const TestFile& file, std::size_t index, const std::string& name);

// They throw Error for bytes that are none of theirs.
std::vector<TestCase> test_cases_from(const std::string& bytes);
TestOutcome test_outcome_from(const std::string& bytes);

/// Takes "demo_test.lua:12: text" apart; a name that Lua has cut ("...folder/demo_test.lua") becomes `path`.
TestOutcome failure_at(const std::string& message, const std::string& path);

}  // namespace meander::script

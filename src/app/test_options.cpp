// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/test_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/options.hpp"
#include "app/output.hpp"

namespace meander {
namespace {

constexpr const char* kFooter = R"(
PATH is a test file, or a folder: all *_test.lua in it and below. What stands behind -- is the table 'arg' of every file.
Each test runs in a process and Lua state of its own.

Exit codes: 0 all passed, 1 a report cannot be written, 2 error on the command line or no test found, 3 a test failed,
130 interrupted.)";

int usage_error(const std::string& message) {
  complain(message + " (meander test --help tells more)");
  return kExitUsage;
}

void add_options(CLI::App& app, TestOptions& options) {
  app.set_help_flag("-h,--help", "this text");
  app.add_option("--filter", options.filter, "only tests whose full name contains TEXT")->type_name("TEXT");
  app.add_option("--seed", options.seed, "seed of math.random, and what each test is given")
      ->check(number_from<std::uint64_t>(0, std::numeric_limits<std::uint64_t>::max()))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--jobs,-j", options.jobs, "tests at a time; 0: one per core")
      ->check(number_from(0, 1024))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--timeout", options.timeout, "seconds that a test may take")
      ->check(number_from(0.01, 1e6, "s"))
      ->type_name("S")
      ->capture_default_str();
  app.add_flag("--fail-fast", options.fail_fast, "stop at the first failure");
  app.add_flag("--list", options.list, "print the names of the tests and run none");
  app.add_flag("--verbose,-v", options.verbose, "name every test and show what it prints");
  app.add_flag("--tap", options.tap, "print the Test Anything Protocol instead of text");
  app.add_option("--junit", options.junit, "write JUnit XML to FILE, too")->type_name("FILE");
  app.add_option("PATH", options.paths, "test files and folders")->type_name("")->check([](const std::string& path) {
    return path.empty() ? std::string("PATH is empty") : std::string();
  });
  add_sandbox_options(app, options.interpreter.sandbox);
}

/// The first word that looks like an option and is none.
std::optional<std::string> unknown_word(const CLI::App& app) {
  for (const std::string& word : app.remaining())
    if (word.size() > 1 && word[0] == '-') return unknown_option(app, word);
  return std::nullopt;
}

}  // namespace

std::optional<int> parse_test_options(const CommandLine& line, TestOptions& options) {
  const auto separator = std::find(line.arguments.begin(), line.arguments.end(), "--");
  if (separator != line.arguments.end()) options.arguments.assign(separator + 1, line.arguments.end());
  options.interpreter = {.lua_dir = line.lua_dir, .sandbox = line.sandbox};
  CLI::App app("meander test: runs scripted tests", "meander test");
  app.footer(kFooter);
  app.allow_extras();
  add_options(app, options);
  std::vector<std::string> words(std::make_reverse_iterator(separator), line.arguments.rend());  // CLI11 wants them so
  try {
    app.parse(words);
    if (options.interpreter.sandbox) validate(*options.interpreter.sandbox, "--sandbox-");
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const std::exception& error) {
    return usage_error(problem_of(app, error));
  }
  if (const auto unknown = unknown_word(app)) return usage_error(*unknown);
  if (options.paths.empty()) return usage_error("PATH is missing: a test file or a folder");
  return std::nullopt;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <exception>
#include <functional>
#include <optional>
#include <string>

#include "script/sandbox.hpp"

namespace CLI {
class App;
}

namespace meander {

/// --sandbox, and --sandbox-NAME for each of its limits, which imply it.
void add_sandbox_options(CLI::App& app, std::optional<script::SandboxOptions>& sandbox);

using WordCheck = std::function<std::string(const std::string& word)>;  ///< gives what is wrong, or nothing
/// For an option that takes a number: "a number from 16 to 1e+06 [MiB] expected, got 'abc'". For int, std::uint64_t and
/// double.
template <class T>
WordCheck number_from(T least, T most, const char* unit = "");

/// What the parser has against the command line, in the words of this program.
std::string problem_of(const CLI::App& app, const std::exception& error);

/// "unknown option '--sede'; did you mean '--seed'?" for a word like "--sede=3".
std::string unknown_option(const CLI::App& app, const std::string& word);

}  // namespace meander

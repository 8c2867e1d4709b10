// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <exception>
#include <optional>
#include <string>

#include "script/sandbox.hpp"

namespace CLI {
class App;
}

namespace meander {

/// --sandbox, and --sandbox-NAME for each of its limits, which imply it.
void add_sandbox_options(CLI::App& app, std::optional<script::SandboxOptions>& sandbox);

/// What the parser has against the command line, in the words of this program.
std::string problem_of(const CLI::App& app, const std::exception& error);

/// "unknown option '--sede'; did you mean '--seed'?" for a word like "--sede=3".
std::string unknown_option(const CLI::App& app, const std::string& word);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "script/interpreter.hpp"

namespace meander::repl {

/// What the prompt says when `input` failed. Positions in what was typed read "line 2: ", or are left out where the
/// input has but one line; frames that only say that something was typed are dropped.
std::string error_text(const script::Outcome& outcome, const std::string& input);

/// A single line that makes nothing but locals: they are gone at the next line.
bool declares_lost_local(const std::string& input);

/// As a Lua literal.
std::string quoted(const std::string& text);

}  // namespace meander::repl

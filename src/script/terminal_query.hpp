// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "render/terminal_caps.hpp"

namespace meander::script {

/// What the terminal says it understands. Asked at the first call and never again, in the 150 ms after which a terminal
/// that gives no answer is taken for one without graphics, until an answer comes late. Only where standard input and
/// output are terminals and no keys wait to be read; else characters, and the next call tries again.
StillMode asked_still_mode(bool at_prompt);

/// For the prompt, when something can be read: where the terminal still owes an answer, this reads what has come, keeps
/// the answer out of the line, and is true. The keys among it are typed ahead.
bool read_late_answer();

/// Keys that were read together with answers, for whoever reads the next line at the prompt. Gives them away.
std::string take_typed_ahead();

}  // namespace meander::script

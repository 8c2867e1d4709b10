// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

namespace meander {

/// From here on: at the end of the process, however it ends, results that could not be written (a full disk) are an
/// error and the exit code says so. A reader that went away ("| head") is none, nor is a standard output that was
/// closed before.
void guard_output();

/// "meander: text" on stderr, behind everything written to stdout before.
void complain(const std::string& text);

/// The descriptor is a terminal that can take back what it shows: TERM is set and not "dumb".
bool is_able_terminal(int descriptor);

}  // namespace meander

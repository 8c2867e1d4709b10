// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once

namespace meander::script {

/// Starts the clock of a sandbox: the computing time of this process and of all that it forks, together. When it is
/// used up, what runs is stopped like by Ctrl-C; what cannot be stopped so, a long call into Lua's C library, ends the
/// process after another second with exit code 1. So does a run that waits for longer than four times the computing
/// time and ten seconds. To be called once, by the main thread.
void start_clock(double seconds);
/// "sandbox: computing time of 60 s used up", or null while there is time left.
const char* clock_verdict();
/// In a forked worker: it ends without a message, its parent has one.
void silence_clock();

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "script/sandbox.hpp"

namespace meander {

/// The second wall of a sandbox, around the process and for good: the clock, the system's limits, and, where the kernel
/// has them, Landlock (files) and seccomp (system calls). What holds without it is in the interpreter. `readable` names
/// files and folders outside of the sandbox's folder that the program itself must read. To be called once, by the main
/// thread, before others are started.
void confine(const script::SandboxOptions& options, const std::vector<std::string>& readable);

// Its parts. False where the kernel does not offer it.

/// From here on files are read and written in `folder`, and read where `readable` and the program's own files are.
bool confine_files(const std::string& folder, const std::vector<std::string>& readable);
/// From here on no other program is started, no network is used, no other process is looked into, and nothing is typed
/// into a terminal.
bool confine_calls();

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/batch.hpp"
#include "app/subcommands.hpp"

namespace meander {

int completion_command(const CommandLine& line) { return run_lua_command("completion", line); }

}  // namespace meander

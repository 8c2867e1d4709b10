// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

namespace meander::script {

/// Creates the global table `meander` and the documented global functions in a state that has the standard libraries
/// and a session (attach()).
void bind_all(lua_State* L);

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

namespace meander::script {

/// Loads meander.pretty while nothing that it uses can have been taken away by a script.
void open_pretty(lua_State* L);

/// Pushes the function of that name in meander.pretty. False, and nothing is pushed, in a state that has none.
bool push_pretty(lua_State* L, const char* name);

}  // namespace meander::script

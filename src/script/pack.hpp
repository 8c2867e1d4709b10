// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <string>

namespace meander::script {

/// The Lua value at `index` as bytes: nil, booleans, numbers, strings, and tables of these whose keys are 1 .. n or
/// strings. A run becomes the table of its figures. Throws ArgumentError for anything else, other keys and cycles
/// included.
std::string pack(lua_State* L, int index);

/// Pushes what pack() wrote.
void unpack(lua_State* L, const std::string& bytes);

}  // namespace meander::script

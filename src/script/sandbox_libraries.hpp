// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <cstddef>

namespace meander::script {

/// Of Lua's libraries, which are all open: keeps what is on a list of harmless functions and drops everything else,
/// then adds those that a sandbox has its own of.
void keep_safe_libraries(lua_State* L);

/// Of a function that stands before another one, which is its upvalue 1: calls that with the arguments that are there.
int call_original(lua_State* L);

// What a sandbox has its own of.

/// Into the table on top of the stack, which is that of the globals or of `debug`.
void add_safe_base(lua_State* L);
void add_safe_debug(lua_State* L);
/// Into the libraries io and os, made from the original tables at these indices.
void add_safe_io(lua_State* L, int original);
void add_safe_os(lua_State* L, int original);
/// Counts `size` bytes that are about to be written; raises an error when it is too much.
void charge_output(lua_State* L, std::size_t size);

}  // namespace meander::script

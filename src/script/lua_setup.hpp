// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <string>
#include <vector>

namespace meander::script {

/// Source name of what is typed at the prompt. There, functions may create globals, and modules are plain names.
inline constexpr const char* kPromptChunk = "=prompt";

/// Reading a global that was never assigned is an error that suggests the nearest name. Assigning one is a declaration
/// at the top level of a script and anywhere at the prompt; elsewhere an error.
void open_strict(lua_State* L);

/// What a script must begin with to do what was typed at the prompt: the modules that were read by their plain names,
/// the globals that functions were the first to assign. Lines of Lua, sorted: "count = nil", "world = meander.world".
std::vector<std::string> declarations(lua_State* L);

/// `require`: the modules packed into the program (from `lua_dir` instead where given), then Lua files on package.path.
/// Binary modules cannot be loaded: they would need the C build of Lua.
void open_modules(lua_State* L, const std::string& lua_dir);

/// `require` looks into `folder` for modules of the user, and nowhere else.
void set_module_folder(lua_State* L, const std::string& folder);

/// coroutine.resume, wrap and close that know which coroutine runs, so that it can be interrupted.
void open_threads(lua_State* L);

/// print and io.write that take the progress line away first.
void open_output(lua_State* L);

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/file_access.hpp"

#include "script/session.hpp"

namespace meander::script {

std::string path_to_read(lua_State*, const std::string& name) { return name; }

std::string path_to_write(lua_State*, const std::string& name) { return name; }

InputFile Lua<InputFile>::read(lua_State* L, int index, const Path& path) {
  return {path_to_read(L, Lua<std::string>::read(L, index, path))};
}

OutputFile Lua<OutputFile>::read(lua_State* L, int index, const Path& path) {
  return {path_to_write(L, Lua<std::string>::read(L, index, path))};
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/kit_value.hpp"

namespace meander::script {

/// Where every file name goes that a script gives, before anything is opened: the path to use. In a sandbox a name that
/// leads out of the folder throws Error, however it does so ("..", symbolic links, devices). Bound functions do not
/// call these, they take an InputFile or OutputFile.
std::string path_to_read(lua_State* L, const std::string& name);
std::string path_to_write(lua_State* L, const std::string& name);

/// Parameter of a bound function: the name of a file that it reads. Completion offers those with the suffixes that the
/// argument's text tells, all where it tells none.
struct InputFile {
  std::string path;
};
/// Parameter of a bound function: the name of a file or folder that it writes.
struct OutputFile {
  std::string path;
};

template <>
struct Lua<InputFile> {
  static InputFile read(lua_State* L, int index, const Path& path);
  static std::string type() { return "file name"; }
};
template <>
struct Lua<OutputFile> {
  static OutputFile read(lua_State* L, int index, const Path& path);
  static std::string type() { return "file name"; }
};

}  // namespace meander::script

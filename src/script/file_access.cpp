// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/file_access.hpp"

#include <algorithm>
#include <filesystem>

#include "base/data_folder.hpp"
#include "script/sandbox_state.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

namespace fs = std::filesystem;

bool is_inside(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// Where `name` leads, all symbolic links followed; empty where that is not inside of the folder, or neither a plain
/// file nor a folder nor nothing. Scripts cannot make links, so that what holds now holds when the file is opened.
fs::path path_inside(const std::string& name, const fs::path& folder) {
  std::error_code failed;
  const fs::path path = fs::weakly_canonical(folder / name, failed);
  if (failed || !is_inside(path, folder)) return {};
  const fs::file_status status = fs::symlink_status(path, failed);  // a link that is left leads nowhere yet
  const bool plain = fs::is_regular_file(status) || fs::is_directory(status);
  return plain || status.type() == fs::file_type::not_found ? path : fs::path();
}

bool there(const fs::path& path) {
  std::error_code failed;
  return !path.empty() && fs::exists(path, failed);
}

[[noreturn]] void refuse(const std::string& name) {
  fail<FileError>("sandbox: '{}' is not in the folder that may be used, or no plain file", name.c_str());
}

/// As short as the user would write it.
std::string shown(const fs::path& path) {
  std::error_code failed;
  const fs::path here = fs::current_path(failed);
  return !failed && is_inside(path, here) ? path.lexically_relative(here).string() : path.string();
}

std::string inside(const Sandbox& sandbox, const std::string& name) {
  const fs::path path = name.find('\0') == std::string::npos ? path_inside(name, sandbox.folder()) : fs::path();
  if (path.empty()) refuse(name);
  return shown(path);
}

/// The file of this name that came with the program; empty if there is none.
fs::path shipped(const std::string& name) {
  std::error_code failed;
  const fs::path folder = fs::canonical(data_folder(), failed);
  if (failed || name.find('\0') != std::string::npos) return {};
  const fs::path path = path_inside(name, folder);
  return there(path) ? path : fs::path();
}

}  // namespace

std::string path_to_read(lua_State* L, const std::string& name) {
  const Sandbox* sandbox = session(L).sandbox.get();
  if (!sandbox) return readable_file(name);
  const fs::path data = shipped(name);
  if (!data.empty() && !there(path_inside(name, sandbox->folder()))) return data.string();
  return inside(*sandbox, name);
}

std::string path_to_write(lua_State* L, const std::string& name) {
  Sandbox* sandbox = session(L).sandbox.get();
  if (!sandbox) return name;
  const std::string path = inside(*sandbox, name);
  sandbox->charge_file(path);
  return path;
}

InputFile Lua<InputFile>::read(lua_State* L, int index, const Path& path) {
  return {path_to_read(L, Lua<std::string>::read(L, index, path))};
}

OutputFile Lua<OutputFile>::read(lua_State* L, int index, const Path& path) {
  return {path_to_write(L, Lua<std::string>::read(L, index, path))};
}

}  // namespace meander::script

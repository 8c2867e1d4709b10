// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <fmt/format.h>
#include <lauxlib.h>
#include <lua.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/names.hpp"
#include "script/file_access.hpp"
#include "script/lua_embedded.hpp"
#include "script/lua_setup.hpp"
#include "script/sandbox_state.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

constexpr std::string_view kPrefix = "meander.";
/// Of the table `package` in the registry: a sandbox has no global of this name.
constexpr const char* kPackage = "meander.package";

int not_found(lua_State* L, const std::string& where) {
  if (where.empty()) return 0;
  lua_pushlstring(L, where.data(), where.size());
  return 1;
}

/// Searcher over the folder of --lua-dir; upvalue 1 is the folder.
int search_folder(lua_State* L) {
  std::string name = luaL_checkstring(L, 1);
  if (!name.starts_with(kPrefix)) return not_found(L, {});
  name.erase(0, kPrefix.size());
  std::replace(name.begin(), name.end(), '.', '/');
  const std::string path = std::string(lua_tostring(L, lua_upvalueindex(1))) + "/" + name + ".lua";
  if (std::error_code error; !std::filesystem::exists(path, error)) return not_found(L, "no file '" + path + "'");
  if (luaL_loadfilex(L, path.c_str(), "t") != LUA_OK) return lua_error(L);
  lua_pushlstring(L, path.data(), path.size());
  return 2;
}

/// "json" is found as meander.json, and misspelt names as the nearest one.
std::string near_module(const std::string& name) {
  const std::string plain = name.starts_with(kPrefix) ? name.substr(kPrefix.size()) : name;
  std::vector<std::string> names;
  for (const EmbeddedModule& module : embedded_modules()) names.emplace_back(module.name.substr(kPrefix.size()));
  const auto near = nearest_name(plain, names);
  return near ? fmt::format("; did you mean '{}{}'?", kPrefix, *near) : std::string();
}

/// The path to read a module of the user from, if it is there and may be read.
std::optional<std::string> readable_module(lua_State* L, const std::string& name) {
  try {
    std::string path = path_to_read(L, name);
    std::error_code failed;
    if (std::filesystem::is_regular_file(path, failed)) return path;
  } catch (const Error&) {
  }
  return std::nullopt;
}

int search_embedded(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  for (const EmbeddedModule& module : embedded_modules()) {
    if (module.name != name) continue;
    const std::string chunk = "=[" + name + "]";
    if (luaL_loadbufferx(L, module.text.data(), module.text.size(), chunk.c_str(), "t") != LUA_OK) return lua_error(L);
    lua_pushliteral(L, ":embedded:");
    return 2;
  }
  return not_found(L, "no module in the program" + near_module(name));
}

/// Searcher of a sandbox: Lua files beside the script, then in the folder of the sandbox, as far as they may be read.
int search_confined(lua_State* L) {
  std::string name = luaL_checkstring(L, 1);
  std::replace(name.begin(), name.end(), '.', '/');
  lua_getfield(L, LUA_REGISTRYINDEX, kPackage);
  lua_getfield(L, -1, "folder");
  const std::filesystem::path beside = lua_tostring(L, -1);
  for (const auto& folder : {std::filesystem::absolute(beside), session(L).sandbox->folder()}) {
    for (const char* suffix : {".lua", "/init.lua"}) {
      const auto path = readable_module(L, (folder / (name + suffix)).string());
      if (!path) continue;
      if (luaL_loadfilex(L, path->c_str(), "t") != LUA_OK) return lua_error(L);
      lua_pushlstring(L, path->data(), path->size());
      return 2;
    }
  }
  return not_found(L, "no file '" + name + ".lua' in the folder of the sandbox");
}

}  // namespace

void open_modules(lua_State* L, const std::string& lua_dir) {
  lua_getglobal(L, "package");
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, kPackage);
  lua_getfield(L, -1, "searchers");  // preload, Lua files, C libraries, C libraries all in one
  lua_createtable(L, 4, 0);
  int count = 0;
  const auto add = [&] { lua_rawseti(L, -2, ++count); };
  lua_rawgeti(L, -2, 1);
  add();
  if (!lua_dir.empty()) {
    lua_pushlstring(L, lua_dir.data(), lua_dir.size());
    lua_pushcclosure(L, search_folder, 1);
    add();
  }
  lua_pushcfunction(L, search_embedded);
  add();
  if (session(L).sandbox)
    lua_pushcfunction(L, search_confined);
  else
    lua_rawgeti(L, -2, 2);
  add();
  lua_setfield(L, -3, "searchers");
  lua_pushliteral(L, "");
  lua_setfield(L, -3, "cpath");
  lua_pushnil(L);
  lua_setfield(L, -3, "loadlib");
  lua_pop(L, 2);
}

void set_module_folder(lua_State* L, const std::string& folder) {
  const std::string path = folder + "/?.lua;" + folder + "/?/init.lua";
  lua_getfield(L, LUA_REGISTRYINDEX, kPackage);
  lua_pushlstring(L, folder.data(), folder.size());
  lua_setfield(L, -2, "folder");
  lua_pushlstring(L, path.data(), path.size());
  lua_setfield(L, -2, "path");
  lua_pop(L, 1);
}

}  // namespace meander::script

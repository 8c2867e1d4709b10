// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/kit_function.hpp"

namespace meander::script {

Reference::Reference(lua_State* L) : life_(session(L).life), key_(luaL_ref(L, LUA_REGISTRYINDEX)) {}

Reference::~Reference() {
  // Releasing only moves numbers between existing registry slots: it takes no memory and cannot raise.
  if (life_->main) luaL_unref(life_->running, LUA_REGISTRYINDEX, key_);
}

lua_State* Reference::push() const {
  if (!life_->main) fail<Error>("the Lua state of this function is closed");
  lua_State* L = life_->running;
  luaL_checkstack(L, 1, nullptr);
  lua_rawgeti(L, LUA_REGISTRYINDEX, key_);
  return L;
}

Function::Function(lua_State* L, int index, const Path& path) {
  if (!lua_isfunction(L, index)) expected(L, index, path, "function");
  lua_pushvalue(L, index);
  reference_ = std::make_shared<const Reference>(L);
  label_ = std::make_shared<const std::string>(path.text() + ": result");
}

}  // namespace meander::script

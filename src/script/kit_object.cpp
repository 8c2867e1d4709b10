// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/kit_object.hpp"

#include <lauxlib.h>

#include <new>

#include "script/sandbox_state.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

/// __gc and __close. The tag is an upvalue: the function may be called on anything by way of the debug library.
int release(lua_State* L) {
  const auto* tag = static_cast<const TypeTag*>(lua_touserdata(L, lua_upvalueindex(1)));
  const RunningScope running(L);
  if (ObjectBox* box = test_box(L, 1, *tag)) box->object.reset();
  return 0;
}

/// Pushes the weak table from object addresses to userdata of a type.
void push_identities(lua_State* L, const TypeTag& tag) {
  push_metatable(L, tag);
  lua_rawgetp(L, -1, &tag);
  lua_remove(L, -2);
}

}  // namespace

ObjectBox* test_box(lua_State* L, int index, const TypeTag& tag) {
  if (lua_type(L, index) != LUA_TUSERDATA || lua_rawlen(L, index) != sizeof(ObjectBox)) return nullptr;
  auto* box = static_cast<ObjectBox*>(lua_touserdata(L, index));
  return box->tag == &tag ? box : nullptr;
}

void push_metatable(lua_State* L, const TypeTag& tag) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &tag) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_newtable(L);
  lua_createtable(L, 0, 1);
  lua_pushliteral(L, "v");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_rawsetp(L, -2, &tag);
  for (const char* event : {"__gc", "__close"}) {
    lua_pushlightuserdata(L, const_cast<TypeTag*>(&tag));
    lua_pushcclosure(L, release, 1);
    lua_setfield(L, -2, event);
  }
  lua_pushstring(L, tag.name);
  lua_setfield(L, -2, "__name");
  lua_pushliteral(L, "locked");
  lua_setfield(L, -2, "__metatable");
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &tag);
}

void push_new(lua_State* L, const TypeTag& tag, std::shared_ptr<void> object) {
  luaL_checkstack(L, 6, nullptr);
  // Everything that may run out of memory comes before the box owns the object.
  push_metatable(L, tag);
  void* memory = lua_newuserdatauv(L, sizeof(ObjectBox), 0);
  new (memory) ObjectBox{&tag, std::move(object)};
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
}

bool push_shared(lua_State* L, const TypeTag& tag, std::shared_ptr<void> object) {
  luaL_checkstack(L, 6, nullptr);
  const void* address = object.get();
  push_identities(L, tag);
  if (lua_rawgetp(L, -1, address) == LUA_TUSERDATA) {
    const ObjectBox* known = test_box(L, -1, tag);
    if (known && known->object.get() == address) return lua_remove(L, -2), false;
  }
  lua_pop(L, 1);
  push_new(L, tag, std::move(object));
  lua_pushvalue(L, -1);
  lua_rawsetp(L, -3, address);
  lua_remove(L, -2);
  return true;
}

void account(lua_State* L, std::size_t bytes) {
  // The collector sees a box of 24 bytes where megabytes hang on it: it is stepped as if Lua had taken that memory.
  constexpr std::size_t kSmall = 64 * 1024;
  std::size_t& debt = session(L).native_debt;
  debt += bytes;
  if (debt < kSmall) return;
  const std::size_t kilobytes = std::min<std::size_t>(debt / 1024, 1 << 20);
  if (session(L).sandbox) session(L).sandbox->add_native(L, debt);
  debt = 0;
  if (lua_gc(L, LUA_GCISRUNNING)) lua_gc(L, LUA_GCSTEP, static_cast<int>(kilobytes));
}

}  // namespace meander::script

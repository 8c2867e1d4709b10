// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/last_run.hpp"

#include <lauxlib.h>

namespace meander::script {
namespace {

const char kLastRuns = 0;  ///< keys the weak table from simulations to their runs in the registry

void push_table(lua_State* L) {
  luaL_checkstack(L, 8, nullptr);
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &kLastRuns) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_createtable(L, 0, 1);
  lua_pushliteral(L, "k");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &kLastRuns);
}

}  // namespace

void remember_runs(lua_State* L, const std::shared_ptr<Sim>& sim, const std::shared_ptr<DriveRuns>& runs) {
  push_table(L);
  push(L, sim);
  push(L, runs);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

std::shared_ptr<DriveRuns> last_runs(lua_State* L, const std::shared_ptr<Sim>& sim) {
  push_table(L);
  push(L, sim);
  lua_rawget(L, -2);
  const ObjectBox* box = test_box(L, -1, tag_of<DriveRuns>);
  auto runs = box ? std::static_pointer_cast<DriveRuns>(box->object) : nullptr;
  lua_pop(L, 2);
  return runs;
}

void push_runs(lua_State* L, const DriveRuns& runs) {
  if (runs.runs.empty())
    lua_pushnil(L);
  else if (runs.listed)
    push(L, runs.runs);
  else
    push(L, runs.runs.front());
}

}  // namespace meander::script

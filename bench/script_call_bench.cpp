// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What a bound call costs over a hand-written lua_CFunction in the same run. Every benchmark runs a Lua loop of kCalls
// calls; the empty loop is its own line. Compare `items_per_second` (calls).
#include <benchmark/benchmark.h>
#include <lauxlib.h>
#include <lualib.h>

#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"

namespace meander::script {
namespace {

constexpr int kCalls = 10000;

struct Thing {
  double size = 1;
  Vec2 at{1, 2};
};

}  // namespace

template <>
struct ObjectName<Thing> {
  static constexpr const char* value = "thing";
};

namespace {

double add(double a, double b) { return a + b; }
double grown(const Thing& thing, double by) { return thing.size + by; }
Vec2 place(const Thing& thing) { return thing.at; }
Thing make() { return {}; }

int raw_add(lua_State* L) {
  lua_pushnumber(L, luaL_checknumber(L, 1) + luaL_checknumber(L, 2));
  return 1;
}
int raw_grown(lua_State* L) {
  const auto* thing = static_cast<const Thing*>(luaL_checkudata(L, 1, "raw_thing"));
  lua_pushnumber(L, thing->size + luaL_checknumber(L, 2));
  return 1;
}

void open_raw(lua_State* L) {
  lua_pushcfunction(L, raw_add);
  lua_setglobal(L, "raw_add");
  new (lua_newuserdatauv(L, sizeof(Thing), 0)) Thing;
  luaL_newmetatable(L, "raw_thing");
  lua_newtable(L);
  lua_pushcfunction(L, raw_grown);
  lua_setfield(L, -2, "grown");
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_setglobal(L, "raw");
}

void open_bound(lua_State* L) {
  Module(L, "kit", "For measuring.")
      .function<&add>(Doc{.name = "add",
                          .text = "Adds.",
                          .args = {{"a", "first"}, {"b", "second"}},
                          .returns = "the sum",
                          .example = "kit.add(1, 2)"})
      .function<&make>(Doc{.name = "make", .text = "Makes a thing.", .returns = "it", .example = "kit.make()"});
  Type<Thing>(L, "For measuring.")
      .method<&grown>(Doc{.name = "grown",
                          .text = "Larger.",
                          .args = {{"by", "how much"}},
                          .returns = "the size",
                          .example = "kit.make():grown(1)"})
      .property<&Thing::size>(PropertyDoc{.name = "size", .text = "Its size.", .example = "kit.make().size"})
      .property<&place>(PropertyDoc{.name = "at", .text = "Its place.", .example = "kit.make().at"});
  luaL_dostring(L, "thing, add = kit.make(), kit.add");
}

void calls(benchmark::State& state, const char* body) {
  Session session;
  lua_State* L = luaL_newstate();
  luaL_openlibs(L);
  attach(L, session);
  open_raw(L);
  open_bound(L);
  const std::string code = fmt::format(
      "local raw_add, raw, add, thing, kit = raw_add, raw, add, thing, kit for i = 1, {} do {} end", kCalls, body);
  if (luaL_loadstring(L, code.c_str())) state.SkipWithError(lua_tostring(L, -1));
  for (auto _ : state) {
    lua_pushvalue(L, -1);
    if (lua_pcall(L, 0, 0, 0)) state.SkipWithError(lua_tostring(L, -1));
  }
  state.SetItemsProcessed(state.iterations() * kCalls);
  lua_close(L);
}

BENCHMARK_CAPTURE(calls, empty_loop, "");
BENCHMARK_CAPTURE(calls, raw_function, "raw_add(i, 2)");
BENCHMARK_CAPTURE(calls, bound_function, "add(i, 2)");
BENCHMARK_CAPTURE(calls, raw_method, "raw:grown(2)");
BENCHMARK_CAPTURE(calls, bound_method, "thing:grown(2)");
BENCHMARK_CAPTURE(calls, bound_property, "local x = thing.size");
BENCHMARK_CAPTURE(calls, bound_point_property, "local x = thing.at");
BENCHMARK_CAPTURE(calls, bound_new_object, "kit.make()");

}  // namespace
}  // namespace meander::script

BENCHMARK_MAIN();

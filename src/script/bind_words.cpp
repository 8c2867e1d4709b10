// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>

#include "base/names.hpp"
#include "script/any.hpp"
#include "script/bind.hpp"
#include "script/kit_module.hpp"

namespace meander::script {
namespace {

std::string kind(const Any& value) {
  const bool named =
      lua_isuserdata(value.L, value.index) && luaL_getmetafield(value.L, value.index, "__name") == LUA_TSTRING;
  return named ? lua_tostring(value.L, -1) : luaL_typename(value.L, value.index);
}

std::string hint(const std::string& name, const std::vector<std::string>& names) { return did_you_mean(name, names); }

}  // namespace

void bind_words(lua_State* L) {
  Module(L, "meander", "A laboratory for sonar navigation.")
      .function<&kind>(Doc{.name = "kind",
                           .text = "What a value is: 'world', 'sim', 'run', ... for objects of meander, otherwise what "
                                   "type() says.",
                           .args = {{"value", "anything"}},
                           .returns = "the word",
                           .example = "print(meander.kind(meander.world.new {}), meander.kind {})"})
      .function<&hint>(Doc{.name = "did_you_mean",
                           .text = "For messages of scripts: the nearest of several names to one that was misspelt.",
                           .args = {{"name", "what was written"}, {"names", "what could have been meant"}},
                           .returns = "\"; did you mean 'x'?\", or an empty text where none is near",
                           .example = "print(meander.did_you_mean('sede', { 'seed', 'time' }))"});
}

}  // namespace meander::script

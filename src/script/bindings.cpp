// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bindings.hpp"

namespace meander::script {

void bind_all(lua_State* L) {
  lua_newtable(L);
  lua_setglobal(L, "meander");
}

}  // namespace meander::script

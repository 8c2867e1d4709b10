// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>

#include "script/completion_place.hpp"
#include "world/world.hpp"

namespace meander::script {

/// The world whose things the arguments of a call may name; `function_end` is the token behind the function. It is that
/// of the object before the colon, of the first argument or of the option `world`, where this is there already. Null
/// where only running something could tell.
std::shared_ptr<const World> world_meant(lua_State* L, const Tokens& tokens, std::size_t function_end);

std::vector<std::string> things_of(const World& world, bool places_only);

}  // namespace meander::script

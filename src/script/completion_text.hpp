// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/completion.hpp"
#include "script/completion_place.hpp"

namespace meander::script {

/// What may stand in quotes that are open at the end: the texts that an option or argument takes, names of things in
/// the world that is meant, modules, files. The last token is the open text.
Completion complete_text(lua_State* L, const Tokens& tokens);

}  // namespace meander::script

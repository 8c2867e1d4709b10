// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "script/docs.hpp"

namespace meander::script {

/// Everything that scripts see as annotations for the Lua language server: editors complete and check with it. Lua that
/// does nothing when it is run.
std::string luals_stubs(const Docs& docs);

}  // namespace meander::script

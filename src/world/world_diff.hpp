// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "world/world.hpp"

namespace meander {

/// What turns `a` into `b`, one line each: "removed obstacle 'crate'", "added place 'hall'",
/// "obstacle 'desk': center (1, 2) -> (1.5, 2)". Things are matched by name. Empty when a == b, and only then.
std::vector<std::string> difference(const World& a, const World& b);

/// A Lua script that builds the world through the script interface: what stood before the first undo step, then every
/// step that stands. Running it gives an equal world whose latest undo steps are those of this one.
std::string world_script(const World& world);

}  // namespace meander

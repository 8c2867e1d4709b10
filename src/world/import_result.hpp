// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "world/world.hpp"

namespace meander {

/// A world made from somebody else's file, and in words what was done: size, counts, what was left out. Lines that
/// begin with "warning: " tell what the user may not expect.
struct Imported {
  World world;
  std::vector<std::string> report;
};

}  // namespace meander

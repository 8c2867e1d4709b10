// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "world/world.hpp"

namespace meander {

/// Reads a world from TOML. Throws FileError "path:line: [obstacle 3] key 'size': {width, height} expected, got ...".
World read_world(const std::string& path);
World world_from_toml(const std::string& text, const std::string& path_for_messages = "world");

/// The one canonical text of a world: world_from_toml(to_toml(w)) == w, and equal worlds give equal texts.
std::string to_toml(const World& world);

/// Atomic: temporary file in the same folder, fsync, rename. Throws FileError.
void write_world(const std::string& path, const World& world);

}  // namespace meander

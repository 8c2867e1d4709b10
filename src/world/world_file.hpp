// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/work.hpp"
#include "world/world.hpp"

namespace meander {

inline constexpr int kWorldFormat = 1;                      ///< the key `format` of [world]
inline constexpr std::size_t kLargestWorldFile = 64 << 20;  ///< [bytes]

/// Reads a world from TOML: one table [world] with format, title, note, bounds and start, then one table per thing,
/// [[obstacle]], [[door]], [[mover]], [[light]] or [[place]], in the order in which they come into the world. The shape
/// of a thing is told by its keys: points (wall), outer (polygon), center and size (box), center and radius (disc), and
/// for doors from and to. Metres and radians. Throws FileError
/// "path:line: [[obstacle]] 'crate': key 'size': [width, height] expected, got 3 numbers".
World read_world(const std::string& path, const Work& work = {});
World world_from_toml(const std::string& text, const std::string& path_for_messages = "world", const Work& work = {});

/// The one canonical text of a world: world_from_toml(to_toml(w)) == w, and equal worlds give equal texts.
std::string to_toml(const World& world);

/// Atomic: temporary file in the same folder, fsync, rename. Throws FileError.
void write_world(const std::string& path, const World& world);

}  // namespace meander

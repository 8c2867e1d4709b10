// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/work.hpp"
#include "world/world.hpp"

namespace meander {

/// Writes what blocks the way now, within the bounds of the world, as a ROS map: YAML (.yaml or .yml) and a PGM of the
/// same name beside it; 0 occupied, 254 free, trinary with the thresholds 0.65 and 0.196. Every cell that a wall or
/// solid reaches into is occupied. Both files are replaced atomically, the image first. Throws FileError.
void export_ros_map(const World& world, const std::string& yaml_path, double resolution = 0.05, const Work& work = {});

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "grid/grid.hpp"

namespace meander {

/// Writes a map of probabilities as a ROS map, YAML (.yaml or .yml) with a PGM of the same name beside it: occupied
/// from 0.65 on, free up to 0.196, else unknown (grey 205); or the image alone (.pgm or .png) with its shades: white
/// free, black occupied. Each file is replaced atomically, the image first. Throws FileError; ArgumentError when the
/// map is empty.
void save_map(const Grid<float>& probability, const std::string& path);

}  // namespace meander

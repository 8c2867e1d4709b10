// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "geometry/shape_index.hpp"

namespace meander {

/// Appends the shape's straight pieces, solids to the left; owner and material are left 0. Discs have none.
void append_walls(const Shape& shape, std::vector<Wall>& walls);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "topology/cell_pool.hpp"

namespace meander::topology {

/// The places and links for other programs: Graphviz with positions in metres, and GraphML with typed attributes.
std::string to_dot(const CellPool& cells);
std::string to_graphml(const CellPool& cells);

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "indicator/path_network.hpp"

namespace meander {

/// Least length from `start` to every indicator, by Dijkstra's algorithm; infinite where there is no way [m]. The
/// oracle that the network is held against.
std::vector<double> dijkstra_distances(const RouteLinks& links, int start);

/// A shortest route by Dijkstra's algorithm, or none.
std::optional<Route> dijkstra_path(const RouteLinks& links, int start, int goal);

}  // namespace meander

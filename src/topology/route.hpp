// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "topology/growing_net.hpp"

namespace meander::topology {

struct RouteOptions {
  double per_link = 0.03;  ///< cost of a link beside its length [m]
  double suspended = 20;   ///< additional cost of a suspended link [m]
  double doubtful = 0;     ///< additional cost of a link of no confidence, in lengths; confidence made no difference
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RouteOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"per_link", "m", "cost of a link beside its length", 0, 1000}, o.per_link);
  visit(Field{"suspended", "m", "additional cost of a suspended link", 0, 1e6}, o.suspended);
  visit(Field{"doubtful", "", "additional cost of links of little confidence: this times (1 - weight), in lengths", 0,
              1e6},
        o.doubtful);
}

/// The cheapest way over the links from one cell to another, both included; nothing when there is none. (Dijkstra; ties
/// to the smaller number.) `avoided`: links that cost as suspended ones do, from one cell to the other.
using CellPairs = std::vector<std::pair<int, int>>;
std::optional<std::vector<int>> route(const CellPool& cells, int from, int to, const RouteOptions& options = {},
                                      const CellPairs& avoided = {});

/// The same to whichever of the cells that `wanted` names is cheapest to reach.
std::optional<std::vector<int>> route_to_nearest(const CellPool& cells, int from,
                                                 const std::function<bool(int)>& wanted,
                                                 const RouteOptions& options = {});

/// The cell whose place is nearest; -1 in an empty map. Looks at all.
int nearest_place(const CellPool& cells, const Vec2& at);
/// The cell whose senses are most like these, wherever it is; -1 in an empty map. Looks at all.
int most_alike(const GrowingNet& net, const float* senses);

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "indicator/indicator_graph.hpp"

namespace meander {

/// What other programs read: Graphviz, graph editors, anything. [m]
std::string to_dot(const IndicatorGraph& graph);
std::string to_graphml(const IndicatorGraph& graph);
std::string to_json(const IndicatorGraph& graph);

/// A way of the contracted graph: what lies between two indicators that are more than a stop in a corridor.
struct ContractedWay {
  IndicatorId a, b;
  double length = 0;                 ///< [m]
  std::vector<IndicatorId> between;  ///< passed on the way from a to b
};
struct ContractedGraph {
  std::vector<IndicatorId> indicators;
  std::vector<ContractedWay> ways;
};

/// Indicators with just two links and nothing unknown are left out, except those of `keep`: what remains are crossings,
/// dead ends and open ends, as in the figures of [DG]. A circle without any keeps its first indicator.
ContractedGraph contracted(const IndicatorGraph& graph, const std::vector<IndicatorId>& keep = {});

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "indicator/indicator_graph.hpp"

namespace meander {

/// The links between indicators 0 .. size() - 1 in flat arrays: what both the network and its oracle read.
class RouteLinks {
 public:
  struct Way {
    int to = 0;
    double length = 0;  ///< [m]
  };
  struct Edge {
    int a = 0, b = 0;
    double length = 0;  ///< [m]
  };

  RouteLinks() = default;
  /// Both directions of every edge. Throws ArgumentError for ends that are not there, and for lengths that are not
  /// > 0: a link without length would let a route pass an indicator twice.
  RouteLinks(int indicators, std::span<const Edge> edges);
  /// Columns are the graph's slots; empty slots have no ways.
  explicit RouteLinks(const IndicatorGraph& graph);

  int size() const { return static_cast<int>(first_.size()) - 1; }
  int indicators() const { return indicators_; }  ///< how many there are: empty slots do not count
  std::span<const Way> ways(int from) const {
    const auto i = static_cast<std::size_t>(from);
    return {ways_.data() + first_[i], ways_.data() + first_[i + 1]};
  }

 private:
  void fill(std::span<const Edge> edges, int columns);
  std::vector<std::size_t> first_{0};
  std::vector<Way> ways_;
  int indicators_ = 0;
};

}  // namespace meander

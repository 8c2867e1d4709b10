// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/route_links.hpp"

#include <cmath>

namespace meander {

RouteLinks::RouteLinks(int indicators, std::span<const Edge> edges) : indicators_(indicators) {
  if (indicators < 0) fail("links: a number of indicators >= 0 expected, got {}", indicators);
  for (const Edge& edge : edges) {
    if (edge.a < 0 || edge.b < 0 || edge.a >= indicators || edge.b >= indicators)
      fail("links: ends from 0 to {} expected, got {} and {}", indicators - 1, edge.a, edge.b);
    if (!(edge.length > 0) || !std::isfinite(edge.length))
      fail("links: a length > 0 [m] expected, got {} between {} and {}", edge.length, edge.a, edge.b);
  }
  fill(edges, indicators);
}

RouteLinks::RouteLinks(const IndicatorGraph& graph) : indicators_(static_cast<int>(graph.size())) {
  std::vector<Edge> edges;
  edges.reserve(graph.links().size());
  for (const Link& link : graph.links())
    edges.push_back({static_cast<int>(link.a.indicator.slot), static_cast<int>(link.b.indicator.slot), link.length});
  fill(edges, static_cast<int>(graph.slots()));
}

void RouteLinks::fill(std::span<const Edge> edges, int columns) {
  first_.assign(static_cast<std::size_t>(columns) + 1, 0);
  for (const Edge& edge : edges) {
    ++first_[static_cast<std::size_t>(edge.a) + 1];
    ++first_[static_cast<std::size_t>(edge.b) + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  ways_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Edge& edge : edges) {
    ways_[next[static_cast<std::size_t>(edge.a)]++] = {edge.b, edge.length};
    ways_[next[static_cast<std::size_t>(edge.b)]++] = {edge.a, edge.length};
  }
}

}  // namespace meander

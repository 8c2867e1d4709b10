// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/dijkstra.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace meander {
namespace {

struct Tree {
  std::vector<double> distance;
  std::vector<int> before;
};

Tree grow(const RouteLinks& links, int start, std::optional<int> goal) {
  if (start < 0 || start >= links.size() || (goal && (*goal < 0 || *goal >= links.size())))
    fail("an indicator from 0 to {} expected, got {}", links.size() - 1, goal.value_or(start));
  const auto columns = static_cast<std::size_t>(links.size());
  Tree tree{std::vector<double>(columns, std::numeric_limits<double>::infinity()), std::vector<int>(columns, -1)};
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  tree.distance[static_cast<std::size_t>(start)] = 0;
  queue.push({0, start});
  while (!queue.empty()) {
    const auto [distance, from] = queue.top();
    queue.pop();
    if (goal && from == *goal) break;
    if (distance > tree.distance[static_cast<std::size_t>(from)]) continue;
    for (const RouteLinks::Way& way : links.ways(from)) {
      const auto to = static_cast<std::size_t>(way.to);
      if (distance + way.length >= tree.distance[to]) continue;
      tree.distance[to] = distance + way.length;
      tree.before[to] = from;
      queue.push({tree.distance[to], way.to});
    }
  }
  return tree;
}

}  // namespace

std::vector<double> dijkstra_distances(const RouteLinks& links, int start) {
  return grow(links, start, std::nullopt).distance;
}

std::optional<Route> dijkstra_path(const RouteLinks& links, int start, int goal) {
  const Tree tree = grow(links, start, goal);
  const double length = tree.distance[static_cast<std::size_t>(goal)];
  if (length == std::numeric_limits<double>::infinity()) return std::nullopt;
  Route route{.indicators = {}, .length = length};
  for (int at = goal; at >= 0; at = tree.before[static_cast<std::size_t>(at)]) route.indicators.push_back(at);
  std::reverse(route.indicators.begin(), route.indicators.end());
  return route;
}

}  // namespace meander

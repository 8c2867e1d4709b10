// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/route.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace meander::topology {
namespace {

/// The cheapest way to the first cell that is wanted.
template <class Wanted>
std::optional<std::vector<int>> cheapest(const CellPool& cells, int from, const Wanted& wanted,
                                         const RouteOptions& options, const CellPairs& avoided) {
  const auto avoids = [&](int a, int b) {
    return std::any_of(avoided.begin(), avoided.end(),
                       [&](const auto& pair) { return pair == std::pair(a, b) || pair == std::pair(b, a); });
  };
  const auto n = static_cast<std::size_t>(cells.slots());
  std::vector<double> cost(n, std::numeric_limits<double>::infinity());
  std::vector<int> before(n, -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[static_cast<std::size_t>(from)] = 0;
  int to = -1;
  for (open.emplace(0, from); !open.empty();) {
    const auto [so_far, cell] = open.top();
    open.pop();
    if (so_far > cost[static_cast<std::size_t>(cell)]) continue;
    if (wanted(cell)) {
      to = cell;
      break;
    }
    for (const Link& link : cells[cell].links) {
      const double length = (cells[link.to].position - cells[cell].position).norm();
      const double next = so_far + length * (1 + options.doubtful * (1 - link.weight)) + options.per_link +
                          (link.suspended || avoids(cell, link.to) ? options.suspended : 0);
      const auto t = static_cast<std::size_t>(link.to);
      if (next > cost[t] || (next == cost[t] && cell >= before[t])) continue;
      cost[t] = next;
      before[t] = cell;
      open.emplace(next, link.to);
    }
  }
  if (to < 0) return std::nullopt;
  std::vector<int> way{to};
  while (way.back() != from) way.push_back(before[static_cast<std::size_t>(way.back())]);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

std::optional<std::vector<int>> route(const CellPool& cells, int from, int to, const RouteOptions& options,
                                      const CellPairs& avoided) {
  return cheapest(
      cells, from, [to](int cell) { return cell == to; }, options, avoided);
}

std::optional<std::vector<int>> route_to_nearest(const CellPool& cells, int from,
                                                 const std::function<bool(int)>& wanted, const RouteOptions& options) {
  return cheapest(cells, from, wanted, options, {});
}

namespace {

/// The cell with the least of something; -1 when there is none, ties to the smaller number.
template <class Measure>
int least(const CellPool& cells, const Measure& measure) {
  int found = -1;
  double best = std::numeric_limits<double>::infinity();
  for (int cell = 0; cell < cells.slots(); ++cell) {
    if (!cells[cell].alive()) continue;
    const double value = measure(cell);
    if (value >= best) continue;
    best = value;
    found = cell;
  }
  return found;
}

}  // namespace

int nearest_place(const CellPool& cells, const Vec2& at) {
  return least(cells, [&](int cell) { return (cells[cell].position - at).squaredNorm(); });
}

int most_alike(const GrowingNet& net, const float* senses) {
  return least(net.cells(), [&](int cell) { return net.metric().squared(net.cells().senses(cell), senses); });
}

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/indicator_storage.hpp"

#include <algorithm>

#include "geometry/angle.hpp"

namespace meander {

std::optional<IndicatorId> winner(const IndicatorGraph& graph, const Vec2& position, double reach) {
  std::optional<IndicatorId> nearest;
  double least = reach * reach;
  for (std::size_t slot = 0; slot < graph.slots(); ++slot) {
    const Indicator* indicator = graph.in_slot(slot);
    if (!indicator) continue;
    const double distance = (indicator->position - position).squaredNorm();
    if (nearest ? distance >= least : distance > least) continue;
    nearest = indicator->id;
    least = distance;
  }
  return nearest;
}

std::optional<PortRef> way_out(const IndicatorGraph& graph, IndicatorId from, IndicatorId to) {
  std::optional<PortRef> best;
  double length = 0, direction = 0;
  const auto consider = [&](const PortRef& out, const Link& link) {
    const double angle = motion_direction(graph, out, to);
    if (best && (link.length > length || (link.length == length && angle >= direction))) return;
    best = out;
    length = link.length;
    direction = angle;
  };
  for (const int index : graph.get(from).links) {
    const Link& link = graph.links()[static_cast<std::size_t>(index)];
    if (link.a.indicator == from && link.b.indicator == to) consider(link.a, link);
    if (link.b.indicator == from && link.a.indicator == to) consider(link.b, link);
  }
  return best;
}

double motion_direction(const IndicatorGraph& graph, const PortRef& out, IndicatorId to) {
  if (out.port >= 0) return graph.port(out).direction;
  const Vec2 way = graph.get(to).position - graph.get(out.indicator).position;
  return angle_of(way.y(), way.x());
}

std::optional<int> next_on_route(const Route& route, int current) {
  const auto here = std::find(route.indicators.begin(), route.indicators.end(), current);
  if (here == route.indicators.end() || here + 1 == route.indicators.end()) return std::nullopt;
  return *(here + 1);
}

}  // namespace meander

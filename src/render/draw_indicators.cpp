// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_indicators.hpp"

#include <algorithm>

#include "geometry/angle.hpp"
#include "render/draw_parts.hpp"
#include "render/draw_world.hpp"

namespace meander {
namespace {

/// Drawn between the indicators as a bow over the way they leave: links in parallel stay apart.
std::vector<Vec2> bow(const IndicatorGraph& graph, const Link& link, double unit) {
  const auto leaving = [&](const PortRef& end) -> Vec2 {
    const Vec2 at = graph.get(end.indicator).position;
    if (end.port < 0) return at;
    const SinCos way = sin_cos(graph.port(end).direction);
    return at + std::min(2.5 * unit, 0.3 * link.length) * Vec2(way.cos, way.sin);
  };
  return {graph.get(link.a.indicator).position, leaving(link.a), leaving(link.b), graph.get(link.b.indicator).position};
}

/// A link by sight that two others lead along as well: drawn, it would only cover them.
bool goes_without_saying(const IndicatorGraph& graph, const Link& link) {
  constexpr double kLonger = 1.1;
  if (link.a.port >= 0 || link.b.port >= 0) return false;
  const auto other = [](const Link& way, IndicatorId from) {
    return way.a.indicator == from ? way.b.indicator : way.a.indicator;
  };
  for (const int i : graph.get(link.a.indicator).links) {
    const Link& first = graph.links()[static_cast<std::size_t>(i)];
    const IndicatorId between = other(first, link.a.indicator);
    if (between == link.a.indicator || between == link.b.indicator) continue;
    for (const int k : graph.get(between).links) {
      const Link& second = graph.links()[static_cast<std::size_t>(k)];
      if (other(second, between) == link.b.indicator && first.length + second.length <= kLonger * link.length)
        return true;
    }
  }
  return false;
}

void draw_port(DrawList& list, const Vec2& at, const Port& port, double unit, const Theme& theme) {
  if (port.state == PortState::linked) return;
  const SinCos way = sin_cos(port.direction);
  const bool unknown = port.state == PortState::unknown;
  const Vec2 tip = at + 2.2 * unit * Vec2(way.cos, way.sin);
  list.items.push_back(DrawPolyline{{at, tip}, false, 0.4 * unit, unknown ? theme.echo : theme.contact, Mark::echo});
}

}  // namespace

void draw_indicators(DrawList& list, const IndicatorGraph& graph, const Theme& theme) {
  const double unit = picture_unit(list.view);
  for (const Link& link : graph.links()) {
    if (goes_without_saying(graph, link)) continue;
    list.items.push_back(DrawPolyline{bow(graph, link, unit), false, 0.35 * unit, theme.path, Mark::path});
  }
  const bool numbers = graph.size() <= 100;  // more of them would only cover each other
  for (const IndicatorId id : graph.ids()) {
    const Indicator& indicator = graph.get(id);
    for (const Port& port : indicator.ports) draw_port(list, indicator.position, port, unit, theme);
    list.items.push_back(DrawDisc{{indicator.position, (numbers ? 1.0 : 0.7) * unit}, theme.place, Mark::start});
    if (numbers)
      list.items.push_back(DrawText{indicator.position - Vec2(0, 0.45 * unit), fmt::format("{}", id.slot + 1),
                                    0.9 * unit, Color{255, 255, 255}, Color{0, 0, 0, 0}, Align::center, Mark::goal});
  }
}

DrawList draw_indicators(const IndicatorGraph& graph) {
  Box bounds{{-1, -1}, {1, 1}};
  bool first = true;
  for (const IndicatorId id : graph.ids()) {
    const Vec2 at = graph.get(id).position;
    bounds = first ? Box{at, at} : Box{bounds.low.cwiseMin(at), bounds.high.cwiseMax(at)};
    first = false;
  }
  bounds.low -= Vec2(0.5, 0.5);
  bounds.high += Vec2(0.5, 0.5);
  DrawList list = draw_floor(bounds, fmt::format("{} indicators, {} links", graph.size(), graph.links().size()));
  draw_indicators(list, graph, theme(Background::light));
  return list;
}

}  // namespace meander

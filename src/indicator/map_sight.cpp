// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/map_sight.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

/// The link by sight between two indicators, if there is one.
std::optional<int> sight_between(const IndicatorGraph& graph, IndicatorId a, IndicatorId b) {
  for (const int index : graph.get(a).links) {
    const Link& link = graph.links()[static_cast<std::size_t>(index)];
    if (link.a.port < 0 && link.b.port < 0 && (link.a.indicator == b || link.b.indicator == b)) return index;
  }
  return std::nullopt;
}

}  // namespace

MapSight::MapSight(const MapPerceptionOptions& perception, const MapSightOptions& options)
    : ports_(perception), perception_(perception), options_(options) {
  validate(options);
}

void MapSight::begin() {
  told_.clear();
  closed_.clear();
}

void MapSight::move_cells() {
  told_.clear();
  perception_ = MapPerception(ports_);
}

void MapSight::close(const IndicatorGraph& graph, IndicatorId from, IndicatorId to) {
  if (const std::optional<int> link = sight_between(graph, from, to))
    closed_.push_back({from, to, graph.links()[static_cast<std::size_t>(*link)].length});
}

bool MapSight::is_closed(IndicatorId a, IndicatorId b, double way) const {
  return std::any_of(closed_.begin(), closed_.end(), [&](const Closed& closed) {
    const bool same = (closed.a == a && closed.b == b) || (closed.a == b && closed.b == a);
    return same && way <= closed.length + options_.keep;
  });
}

void MapSight::look(IndicatorGraph& graph, IndicatorId here, const ConfigurationSpace& map, const Vec2& goal) {
  ids_ = graph.ids();
  places_.clear();
  for (const IndicatorId id : ids_) places_.push_back(graph.get(id).position);
  const Vec2 at = graph.get(here).position;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if ((places_[i] - at).norm() > options_.near) continue;
    if (ids_[i].slot >= told_.size()) told_.resize(ids_[i].slot + 1);
    Told& told = told_[ids_[i].slot];
    if (still_holds(told, ids_[i], places_[i], map)) continue;
    tell_ports(graph, i, map, goal);
    const double reach = tell_links(graph, ids_[i], map);
    told = {ids_[i], map.version(), ids_.size(), reach};
  }
}

bool MapSight::still_holds(const Told& told, IndicatorId id, const Vec2& place, const ConfigurationSpace& map) const {
  if (told.id != id || told.indicators != ids_.size()) return false;
  const Cell at = map.frame().cell(place);
  const int far = static_cast<int>(std::max(ports_.window, told.reach) / map.resolution()) + 1;
  return map.changed({at.x - far, at.y - far}, {at.x + far, at.y + far}) <= told.version;
}

/// What was found closed or led nowhere stays so, as long as the map tells a port there.
void MapSight::tell_ports(IndicatorGraph& graph, std::size_t which, const ConfigurationSpace& map, const Vec2& goal) {
  const IndicatorId id = ids_[which];
  std::vector<Port> ports;
  for (const MapPort& seen : perception_.ports(map, places_, which, goal)) {
    Port port;
    const std::vector<Port>& before = graph.get(id).ports;
    for (std::size_t p = 0; p < before.size(); ++p)
      if ((port_position(graph, {id, static_cast<int>(p)}) - seen.position).norm() <= options_.keep) port = before[p];
    port.direction = seen.direction;
    port.reach = (seen.position - places_[which]).norm();
    port.bound = seen.bound;
    ports.push_back(port);
  }
  graph.set_ports(id, std::move(ports));
}

/// So far a link of this length is looked for: what is seen `link` far, what was driven a little farther than it was
/// long, for a way over cells has corners.
double MapSight::reach(double length) const {
  constexpr double kCorners = 1.1;
  return length > options_.link ? kCorners * length + options_.keep : options_.link;
}

/// Gives how far links were looked for [m].
double MapSight::tell_links(IndicatorGraph& graph, IndicatorId id, const ConfigurationSpace& map) {
  const Vec2 from = graph.get(id).position;
  double far = options_.link;
  for (const int link : graph.get(id).links)
    far = std::max(far, reach(graph.links()[static_cast<std::size_t>(link)].length));
  field_.spread(map, map.frame().cell(from), far);
  for (const IndicatorId other : ids_) {
    const Vec2 to = graph.get(other).position;
    if (other == id || (to - from).norm() > far) continue;
    const std::optional<int> known = sight_between(graph, id, other);
    const double length = known ? graph.links()[static_cast<std::size_t>(*known)].length : 0;
    const double way = field_.at(map.frame().cell(to));
    if (way > reach(length) || is_closed(id, other, way)) {
      if (known) graph.unlink(*known);
    } else if (!known) {
      graph.link({id}, {other}, std::max(way, map.resolution()));
    } else if (length != way && way > 0) {
      graph.set_length(*known, way);
    }
  }
  return far;
}

void MapSight::drove(IndicatorGraph& graph, IndicatorId from, IndicatorId to, double walked) {
  if (from == to || sight_between(graph, from, to) || is_closed(from, to, walked)) return;
  graph.link({from}, {to}, std::max(walked, (graph.get(to).position - graph.get(from).position).norm()));
  for (const IndicatorId end : {from, to})
    if (end.slot < told_.size()) told_[end.slot] = {};  // the map is asked about it when either is decided at again
}

Vec2 port_position(const IndicatorGraph& graph, const PortRef& ref) {
  const Port& port = graph.port(ref);
  const SinCos way = sin_cos(port.direction);
  return graph.get(ref.indicator).position + port.reach * Vec2(way.cos, way.sin);
}

}  // namespace meander

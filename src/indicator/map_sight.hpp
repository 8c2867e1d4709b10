// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "indicator/indicator_graph.hpp"
#include "indicator/map_perception.hpp"

namespace meander {

struct MapSightOptions {
  double near = 3.2;
  double link = 3;
  double keep = 0.3;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapSightOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"near", "m", "indicators within this of the robot have their ports told anew", 0.1, 1000}, o.near);
  visit(Field{"link", "m", "indicators with a free way of at most this between them are linked", 0.1, 1000}, o.link);
  visit(Field{"keep", "m", "a port that is so near to one given up before is given up", 0, 100}, o.keep);
}

/// Tells a graph what a map knows of the indicators near the robot: ports anew wherever the map has changed, links by
/// sight. To be called by Explorer::perceive. One for one map and one graph.
class MapSight {
 public:
  explicit MapSight(const MapPerceptionOptions& perception = {}, const MapSightOptions& options = {});

  void look(IndicatorGraph& graph, IndicatorId here, const ConfigurationSpace& map, const Vec2& goal);

  /// A run begins: nothing counts as told, nothing as closed.
  void begin();
  /// The link by sight was driven and found blocked: in this run none as short is told between the two, whatever the
  /// map says; a longer one goes by another way.
  void close(const IndicatorGraph& graph, IndicatorId from, IndicatorId to);
  /// The robot has driven from one to the other, over so much way [m]: they are linked, however far the map sees, until
  /// it shows that no way leads there any more.
  void drove(IndicatorGraph& graph, IndicatorId from, IndicatorId to, double walked);
  /// The map has grown: cells are others.
  void move_cells();

 private:
  /// What an indicator was told last.
  struct Told {
    IndicatorId id;
    std::uint64_t version = 0;   ///< of the map
    std::size_t indicators = 0;  ///< how many there were
    double reach = 0;            ///< of its links [m]
  };
  /// What was found blocked.
  struct Closed {
    IndicatorId a, b;
    double length = 0;  ///< [m]
  };
  double reach(double length) const;
  bool is_closed(IndicatorId a, IndicatorId b, double way) const;
  bool still_holds(const Told& told, IndicatorId id, const Vec2& place, const ConfigurationSpace& map) const;
  void tell_ports(IndicatorGraph& graph, std::size_t which, const ConfigurationSpace& map, const Vec2& goal);
  double tell_links(IndicatorGraph& graph, IndicatorId id, const ConfigurationSpace& map);

  MapPerceptionOptions ports_;
  MapPerception perception_;
  MapSightOptions options_;
  GeodesicField field_;
  std::vector<IndicatorId> ids_;
  std::vector<Vec2> places_;
  std::vector<Told> told_;  ///< by slot
  std::vector<Closed> closed_;
};

/// Where a port is that a map told: `reach` from its indicator as the crow flies.
Vec2 port_position(const IndicatorGraph& graph, const PortRef& ref);

}  // namespace meander

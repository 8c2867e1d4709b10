// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The sonar explorer's way from indicator to indicator when its ports are read off the polar profile.
#include "autonomy/sonar_explorer.hpp"
#include "indicator/indicator_storage.hpp"

namespace meander {
namespace {

constexpr double kAway = 1.1;     ///< the indicator just left is not come back to before so much way [m]
constexpr double kNewAim = 0.35;  ///< an aim that is so far from the last begins a new stretch [m]

}  // namespace

/// [DG] section 2, item 1: as long as the way leads on in one direction there is nothing to decide. An indicator that
/// is come by is driven to, for its motion directions hold there.
void SonarExplorer::follow_profile() {
  if (toward_ != Toward::port) return;
  const IndicatorGraph& graph = explorer_.graph();
  if (const auto known = winner(graph, at_, options_.explorer.same))
    if ((graph.get(*known).position - way_.left()).norm() > options_.explorer.same || way_.walked() > kAway)
      return drive_to(Toward::indicator, graph.get(*known).position);
  if (way_.follow() != ProfileWay::Found::way) {
    toward_ = Toward::nothing;
  } else if ((way_.aim() - aim_).norm() > kNewAim) {
    drive_to(Toward::port, way_.aim());
  } else {
    aim_ = way_.aim();
  }
}

/// A known link was driven over the map: it is come by at the port where it ends, wherever the robot turned last.
void SonarExplorer::perceive_by_profile(Percept& percept) {
  percept.ports = way_.openings();
  percept.back = way_.back();
  const auto& left = explorer_.state().left_by;
  if (!left || left->port < 0) return;
  const IndicatorGraph& graph = explorer_.graph();
  const auto end = graph.other_end(*left);
  if (end && end->port >= 0 && winner(graph, percept.position, options_.explorer.same) == end->indicator)
    percept.back = graph.port(*end).direction;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <span>
#include <string>

#include "indicator/explorer_options.hpp"
#include "indicator/indicator_graph.hpp"

namespace meander {

/// All that a rule sees when it decides.
struct Situation {
  const IndicatorGraph& graph;
  const ExplorerOptions& options;
  IndicatorId at;              ///< where the robot stands
  std::optional<int> came_by;  ///< port of it by which it came; none: it has just been set down
  Vec2 goal{0, 0};
  std::optional<IndicatorId> at_goal;  ///< the indicator at the goal, once it was reached
  std::span<const double> from_here;   ///< length of the shortest known way, by slot [m]
  std::span<const double> from_start;  ///< the same from where the run began
  std::uint64_t decision = 0;          ///< number of this decision, over all runs
  bool fresh = true;                   ///< the indicator here was placed just now
};

/// What a rule wants: an indicator to go to, and there a port to leave by that is not known yet (port -1: none, the
/// indicator itself is meant). `text` says why, in words.
struct Intent {
  PortRef target;
  const char* text = "";
};

/// Rules 3 and 4 of [DG], section 2, with its section 3, as `options.rules` tells. None: nothing left to do by them.
std::optional<Intent> decide_by_rules(const Situation& situation);

/// Those that the rules are compared with.
std::optional<Intent> decide_by_baseline(const Situation& situation);

/// Calls visit(PortRef, const Port&) for the unknown ports of all indicators that a known way leads to.
template <class Visit>
void for_unknown_ports(const Situation& situation, Visit visit) {
  for (std::size_t slot = 0; slot < situation.graph.slots(); ++slot) {
    const Indicator* indicator = situation.graph.in_slot(slot);
    if (!indicator || !(situation.from_here[slot] < 1e300)) continue;
    for (std::size_t p = 0; p < indicator->ports.size(); ++p)
      if (indicator->ports[p].state == PortState::unknown)
        visit(PortRef{indicator->id, static_cast<int>(p)}, indicator->ports[p]);
  }
}

/// No way from the indicator to the goal by this port is shorter than this [m]: a step straight on, then as the crow
/// flies.
double least_way_on(const Situation& situation, const PortRef& ref, double weight = 1);

/// Could a way by this unknown port make the known route from the start to the goal shorter by more than `eps`?
bool may_shorten(const Situation& situation, const PortRef& ref);

/// The port, of those that pass, with the least cost; of equal ones that of the lower serial number, then that with the
/// least direction: never that which happens to be stored first.
class LeastPort {
 public:
  void offer(const Situation& situation, const PortRef& ref, double cost);
  const std::optional<PortRef>& best() const { return best_; }
  double cost() const { return cost_; }

 private:
  std::optional<PortRef> best_;
  double cost_ = 0, direction_ = 0;
};

/// Angle between a port's direction and that of the goal, its attraction [rad].
double off_goal(const Situation& situation, const PortRef& ref);

}  // namespace meander

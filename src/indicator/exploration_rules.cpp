// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/exploration_rules.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

constexpr double kLess = 1e-9;  ///< lengths that differ by less are equal [m]

const double& length_to(std::span<const double> lengths, IndicatorId id) { return lengths[id.slot]; }

bool route_known(const Situation& s) { return s.at_goal && std::isfinite(length_to(s.from_here, *s.at_goal)); }

/// [DG] rule 3: an unknown direction here is examined; of several, that on which the target's attraction is strongest.
std::optional<Intent> examine_here(const Situation& s, bool only_useful) {
  LeastPort least;
  const std::vector<Port>& ports = s.graph.get(s.at).ports;
  for (std::size_t p = 0; p < ports.size(); ++p) {
    const PortRef ref{s.at, static_cast<int>(p)};
    if (ports[p].state != PortState::unknown || (only_useful && route_known(s) && !may_shorten(s, ref))) continue;
    least.offer(s, ref, off_goal(s, ref));
  }
  if (!least.best()) return std::nullopt;
  return Intent{*least.best(), "an unknown direction here (rule 3)"};
}

/// [DG] rule 4: the indicator nearest to the target; `open` asks for one that has an unknown direction left.
std::optional<IndicatorId> nearest_to_goal(const Situation& s, bool open) {
  std::optional<IndicatorId> nearest;
  double least = 0;
  for (std::size_t slot = 0; slot < s.graph.slots(); ++slot) {
    const Indicator* i = s.graph.in_slot(slot);
    if (!i || !std::isfinite(s.from_here[slot])) continue;
    if (open && std::none_of(i->ports.begin(), i->ports.end(),
                             [](const Port& port) { return port.state == PortState::unknown; }))
      continue;
    const double distance = (i->position - s.goal).norm();
    if (nearest && distance >= least) continue;
    nearest = i->id;
    least = distance;
  }
  return nearest;
}

/// The rules to the letter. They come to a standstill where nothing unknown is left at the indicator nearest to the
/// target.
std::optional<Intent> literal(const Situation& s) {
  const std::vector<Port>& ports = s.graph.get(s.at).ports;
  if (s.fresh && ports.size() == 1 && s.came_by)  // section 3, action 2
    return Intent{{s.at, *s.came_by}, "a dead end: back to the previous indicator (section 3)"};
  if (const auto here = examine_here(s, false)) return here;
  if (route_known(s)) return Intent{{*s.at_goal}, "the known route to the target (rule 4)"};
  const auto nearest = nearest_to_goal(s, false);
  if (!nearest || *nearest == s.at) return std::nullopt;
  return Intent{{*nearest}, "the indicator nearest to the target (rule 4)"};
}

/// [DG+] Rule 4 among indicators that have an unknown direction left, so that it cannot come to a standstill; rule 3
/// passes by directions that cannot shorten the known route.
std::optional<Intent> repaired(const Situation& s) {
  if (const auto here = examine_here(s, true)) return here;
  if (route_known(s)) return Intent{{*s.at_goal}, "the known route to the target (rule 4)"};
  const auto nearest = nearest_to_goal(s, true);
  if (!nearest) return std::nullopt;
  return Intent{{*nearest}, "the indicator nearest to the target that has an unknown direction (rule 4)"};
}

/// [DG+] Rules 3 and 4 in one: of all unknown directions anywhere, the one by which the way to the target is shortest
/// if all goes well beyond it; the known route when none can be better. Rule 3 alone examines only what lies on the way
/// and stops short of the optimum.
std::optional<Intent> optimistic(const Situation& s) {
  const bool known = route_known(s);
  LeastPort least;
  for_unknown_ports(s, [&](const PortRef& ref, const Port&) {
    if (known && !may_shorten(s, ref)) return;
    // A weight above 1 would leave ways out that are shorter: once a route is known, it is 1.
    least.offer(s, ref, length_to(s.from_here, ref.indicator) + least_way_on(s, ref, known ? 1 : s.options.weight));
  });
  if (known && !(least.best() && least.cost() < length_to(s.from_here, *s.at_goal) - kLess))
    return Intent{{*s.at_goal}, "the known route to the target: nothing unknown is nearer (rule 4)"};
  if (!least.best()) return std::nullopt;
  return Intent{*least.best(), known ? "an unknown direction that may shorten the route (rule 3)"
                                     : "the unknown direction by which the target seems nearest (rules 3 and 4)"};
}

}  // namespace

double least_way_on(const Situation& s, const PortRef& ref, double weight) {
  const Port& port = s.graph.port(ref);
  const double step = std::min(s.options.step, port.reach);
  const SinCos direction = sin_cos(port.direction);
  const Vec2 there = s.graph.get(ref.indicator).position + step * Vec2(direction.cos, direction.sin);
  return std::max(step + weight * (there - s.goal).norm(), port.bound);
}

bool may_shorten(const Situation& s, const PortRef& ref) {
  const double known = length_to(s.from_start, *s.at_goal);
  return length_to(s.from_start, ref.indicator) + least_way_on(s, ref) < (1 - s.options.eps) * known - kLess;
}

double off_goal(const Situation& s, const PortRef& ref) {
  const Vec2 way = s.goal - s.graph.get(ref.indicator).position;
  return std::abs(angle_between(s.graph.port(ref).direction, angle_of(way.y(), way.x())));
}

void LeastPort::offer(const Situation& s, const PortRef& ref, double cost) {
  const double direction = s.graph.port(ref).direction;
  if (best_) {
    if (cost > cost_ + kLess) return;
    const bool equal = cost >= cost_ - kLess;
    if (equal && std::pair(best_->indicator, direction_) <= std::pair(ref.indicator, direction)) return;
  }
  best_ = ref;
  cost_ = cost;
  direction_ = direction;
}

std::optional<Intent> decide_by_rules(const Situation& situation) {
  switch (situation.options.rules) {
    case ExplorerRules::literal:
      return literal(situation);
    case ExplorerRules::repaired:
      return repaired(situation);
    case ExplorerRules::optimistic:
      return optimistic(situation);
  }
  return std::nullopt;
}

}  // namespace meander

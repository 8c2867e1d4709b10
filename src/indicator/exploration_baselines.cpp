// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What the paper's rules are compared with, on the same graph and with the same perception. A route to the target that
// is known is taken, except by the random walk.
#include <cmath>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "indicator/exploration_rules.hpp"

namespace meander {
namespace {

/// The indicator placed last that has an unknown direction.
std::optional<Intent> depth_first(const Situation& s) {
  LeastPort least;
  for_unknown_ports(s, [&](const PortRef& ref, const Port&) {
    least.offer(s, ref, -static_cast<double>(ref.indicator.slot) * 10 + off_goal(s, ref));
  });
  if (!least.best()) return std::nullopt;
  return Intent{*least.best(), "an unknown direction of the youngest indicator that has one (depth first)"};
}

/// Trémaux: no passage more than twice; on an indicator that was there already, back at once from a new passage.
std::optional<Intent> tremaux(const Situation& s) {
  const std::vector<Port>& ports = s.graph.get(s.at).ports;
  if (!s.fresh && s.came_by && ports[static_cast<std::size_t>(*s.came_by)].passed == 1)
    return Intent{{s.at, *s.came_by}, "a passage that led to where it was before: back (Tremaux)"};
  for (int passed = 0; passed < 2; ++passed) {
    LeastPort least;
    for (std::size_t p = 0; p < ports.size(); ++p) {
      const PortRef ref{s.at, static_cast<int>(p)};
      const bool closed = ports[p].state == PortState::blocked || ports[p].state == PortState::dead_end;
      if (!closed && ports[p].passed == passed) least.offer(s, ref, off_goal(s, ref));
    }
    if (least.best())
      return Intent{*least.best(), passed ? "all passages were taken: back by the one taken once (Tremaux)"
                                          : "a passage that was not taken yet (Tremaux)"};
  }
  return depth_first(s);  // indicators that see each other have passages without marks
}

/// The unknown direction with the shortest way to it.
std::optional<Intent> nearest(const Situation& s) {
  LeastPort least;
  for_unknown_ports(s, [&](const PortRef& ref, const Port&) { least.offer(s, ref, s.from_here[ref.indicator.slot]); });
  if (!least.best()) return std::nullopt;
  return Intent{*least.best(), "the nearest unknown direction (frontier)"};
}

/// The unknown direction with the shortest way to it and on to the target as the crow flies.
std::optional<Intent> goal_frontier(const Situation& s) {
  LeastPort least;
  for_unknown_ports(s, [&](const PortRef& ref, const Port&) {
    least.offer(s, ref, s.from_here[ref.indicator.slot] + least_way_on(s, ref));
  });
  if (!least.best()) return std::nullopt;
  return Intent{*least.best(), "the unknown direction nearest on the way to the target (frontier)"};
}

/// Any way out that is not closed. The order in which ports are stored must not matter: the draw is over directions.
std::optional<Intent> random_walk(const Situation& s) {
  const Indicator& here = s.graph.get(s.at);
  std::optional<Intent> drawn;
  std::uint64_t least = ~std::uint64_t{0};
  const auto draw = [&](const PortRef& target, double direction) {
    const auto sector = static_cast<std::uint64_t>(std::llround((direction + 4) * 1e6));
    std::uint64_t word = trial_seed(trial_seed(s.options.seed, s.decision), sector);
    if (target.port < 0) word = trial_seed(word, target.indicator.slot);  // several may be seen in one direction
    if (word >= least) return;
    least = word;
    drawn = Intent{target, "any way out (random walk)"};
  };
  for (std::size_t p = 0; p < here.ports.size(); ++p)
    if (here.ports[p].state != PortState::blocked && here.ports[p].state != PortState::dead_end)
      draw({s.at, static_cast<int>(p)}, here.ports[p].direction);
  for (const int link : here.links) {  // to indicators in sight
    const Link& way = s.graph.links()[static_cast<std::size_t>(link)];
    if (way.a.port >= 0 || way.b.port >= 0) continue;
    const IndicatorId there = way.a.indicator == s.at ? way.b.indicator : way.a.indicator;
    const Vec2 on = s.graph.get(there).position - here.position;
    draw({there}, angle_of(on.y(), on.x()));
  }
  return drawn;
}

}  // namespace

std::optional<Intent> decide_by_baseline(const Situation& s) {
  if (s.options.explorer == ExplorerKind::random_walk) return random_walk(s);
  if (s.at_goal && std::isfinite(s.from_here[s.at_goal->slot]))
    return Intent{{*s.at_goal}, "the known route to the target"};
  switch (s.options.explorer) {
    case ExplorerKind::tremaux:
      return tremaux(s);
    case ExplorerKind::depth_first:
      return depth_first(s);
    case ExplorerKind::goal_frontier:
      return goal_frontier(s);
    default:
      return nearest(s);
  }
}

}  // namespace meander

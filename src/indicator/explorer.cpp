// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/explorer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/angle.hpp"
#include "indicator/indicator_storage.hpp"

namespace meander {

Explorer::Explorer(const Vec2& goal, const ExplorerOptions& options) : goal_(goal), options_(options) {
  validate(options);
  if (!goal.allFinite()) fail("goal: finite position expected, got ({}, {})", goal.x(), goal.y());
}

void Explorer::begin() {
  const ExplorerState before = std::exchange(state_, {});
  const int run = state_.run = before.run + 1;
  state_.decisions = before.decisions;
  state_.at_goal = before.at_goal;
  decision_ = {};
  if (options_.recheck == 0) return;
  for (const IndicatorId id : graph_.ids())  // [DG+] a closed way may be open again: it is looked at, ever more rarely
    for (int p = 0; p < static_cast<int>(graph_.get(id).ports.size()); ++p) {
      const Port& port = graph_.port({id, p});
      if (port.state != PortState::blocked && port.state != PortState::dead_end) continue;
      const int wait = options_.recheck << std::clamp(port.failures - 1, 0, 10);
      if (run >= port.closed_run + wait) graph_.reopen({id, p});
    }
}

/// [DG] section 2: "all items are repeated on each step of motion" (7), each step ending where there is something to
/// decide; on the way between (1) the navigator is on its own.
const Decision& Explorer::step(const Percept& percept) {
  if (decision_.ending != Ending::driving)
    fail<Error>("explorer: the run is over ({}), begin() another", decision_.reason);
  if (state_.run == 0) begin();
  const std::uint64_t before = graph_.revision();
  state_.walked += percept.walked;
  ++state_.decisions;
  ++state_.in_run;
  if (way_is_closed(percept)) return turn_back();  // 6: a known way that ends early; section 3, action 2
  arrive(percept);                                 // 2, 5: the indicator of this place, a new one if there is none
  if (perceive)
    perceive(graph_, *state_.at);
  else
    look(percept.ports);  // 2, 6: its motion directions; links that have closed are removed
  if (percept.back) state_.came_by = nearest_port(*percept.back);
  tie(percept.walked);  // 2: the link with the indicator before
  state_.idle = graph_.revision() == before ? state_.idle + 1 : 0;
  return decide();  // 3, 4
}

const Decision& Explorer::decide() {
  if ((graph_.get(*state_.at).position - goal_).norm() <= options_.tolerance) {
    state_.at_goal = *state_.at;
    return end(Ending::reached, "the goal is reached");
  }
  std::string why;
  if (spent(why)) return end(Ending::budget, why);
  for (;;) {
    find_ways();
    const Situation situation = this->situation();
    const bool baseline = options_.explorer != ExplorerKind::indicator;
    if (const auto intent = baseline ? decide_by_baseline(situation) : decide_by_rules(situation))
      return carry_out(*intent);
    bool left = false;
    for_unknown_ports(situation, [&](const PortRef&, const Port&) { left = true; });
    if (left)
      return end(Ending::trapped,
                 "the rules come to a standstill: unknown directions are left, but none that "
                 "they ask for");
    if (!reopen_all())  // [DG+] what was found closed is tried once more before the goal is given up
      return end(
          Ending::no_passable_direction,
          fmt::format("no passable direction left: all ways of the {} indicators are known, none leads to the goal",
                      graph_.size()));
  }
}

/// A way that was known to lead on, or was closed before, and now ends where no indicator stands.
bool Explorer::way_is_closed(const Percept& percept) const {
  if (!state_.left_by || !state_.at) return false;
  if (percept.blocked) return true;
  const bool dead_end = !perceive && percept.ports.size() <= 1 && !knows(percept.position);
  if (!dead_end || state_.left_by->port < 0) return false;
  const Port& port = graph_.port(*state_.left_by);
  return port.link >= 0 || port.failures > 0;
}

const Decision& Explorer::turn_back() {
  const PortRef left = *state_.left_by;
  const IndicatorId home = *state_.at;
  if (left.port >= 0) {
    const Port port = graph_.port(left);
    if (port.link >= 0 || port.failures > 0)
      graph_.block(left, state_.run);
    else if (port.tries + 1 >= options_.tries)
      graph_.give_up(left, state_.run);
    else
      graph_.set_tries(left, port.tries + 1);
  } else {
    for (const int link : std::vector<int>(graph_.get(home).links)) {
      const Link& way = graph_.links()[static_cast<std::size_t>(link)];
      if (decision_.to && (way.a == left || way.b == left) &&
          (way.a.indicator == *decision_.to || way.b.indicator == *decision_.to)) {
        graph_.unlink(link);
        break;
      }
    }
  }
  state_.idle = 0;
  state_.left_by.reset();
  Decision decision;
  decision.back = true;
  decision.to = home;
  decision.out = left;
  decision.target = {home};
  decision.reason = "the way is closed: back to the previous indicator (rule 6, section 3)";
  if (left.port >= 0) decision.direction = wrap_angle(graph_.port(left).direction + kPi);
  return told(std::move(decision));
}

void Explorer::arrive(const Percept& percept) {
  const std::optional<IndicatorId> known = winner(graph_, percept.position, options_.same);
  const IndicatorId here = known ? *known : graph_.place(percept.position);
  state_.fresh = !known;
  state_.at = here;
  state_.came_by.reset();
  if (!state_.start) state_.start = here;
  if (!known && on_indicator) on_indicator(here);
}

/// Ports keep their directions ([DG] Figure 3: the model must not change continually near an indicator): what is seen
/// is matched with what is stored, and only the rest is new or gone.
void Explorer::look(const std::vector<SeenPort>& seen) {
  const IndicatorId here = *state_.at;
  std::vector<char> used(seen.size(), 0);
  const int stored = static_cast<int>(graph_.get(here).ports.size());
  for (int p = 0; p < stored; ++p) {
    const PortRef ref{here, p};
    const Port port = graph_.port(ref);
    std::size_t best = seen.size();
    double least = options_.match;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double off = std::abs(angle_between(port.direction, seen[i].direction));
      if (used[i] || off > least || nearest_port(seen[i].direction) != p) continue;
      least = off;
      best = i;
    }
    if (best < seen.size()) {
      used[best] = 1;
      if (port.misses >= options_.evidence) graph_.reopen(ref);  // it is to be seen again
      graph_.set_seen(ref, seen[best].reach, 0);
    } else if (port.misses < options_.evidence) {
      graph_.set_seen(ref, port.reach, port.misses + 1);
      if (port.misses + 1 >= options_.evidence) graph_.block(ref, state_.run);  // 6
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (!used[i]) graph_.add_port(here, seen[i].direction, seen[i].reach);
}

/// Of the indicator here, within `match`.
std::optional<int> Explorer::nearest_port(double direction) const {
  const std::vector<Port>& ports = graph_.get(*state_.at).ports;
  std::optional<int> nearest;
  double least = options_.match;
  for (std::size_t p = 0; p < ports.size(); ++p) {
    const double off = std::abs(angle_between(ports[p].direction, direction));
    if (off > least) continue;
    least = off;
    nearest = static_cast<int>(p);
  }
  return nearest;
}

/// Links the port that the robot left by with that it came by.
void Explorer::tie(double walked) {
  const std::optional<PortRef> left = std::exchange(state_.left_by, std::nullopt);
  if (!left || !state_.came_by || !(walked > 0) || !graph_.alive(left->indicator)) return;
  const PortRef here{*state_.at, *state_.came_by};
  if (here == *left) {  // it came back by the way it went
    if (graph_.port(here).state == PortState::unknown) graph_.give_up(here, state_.run);
    return;
  }
  graph_.pass(here);
  if (left->port < 0) return;  // a link by sight is whoever sees it to make
  if (graph_.other_end(here) == *left) {
    const int link = graph_.port(here).link;
    const double known = graph_.links()[static_cast<std::size_t>(link)].length;
    const double length = known + 0.3 * (walked - known);  // the newest drive counts for so much
    if (length != known) graph_.set_length(link, length);
  } else {
    graph_.link(*left, here, walked);
  }
}

const Decision& Explorer::carry_out(const Intent& intent) {
  Decision decision;
  decision.target = intent.target;
  decision.reason = intent.text;
  decision.out = intent.target;
  if (intent.target.indicator != *state_.at) {
    const Route route = from_here_.route_to(static_cast<int>(intent.target.indicator.slot));
    const auto next = next_on_route(route, static_cast<int>(state_.at->slot));
    if (!next) return end(Ending::trapped, "no known way leads where the rules want to go");
    decision.to = graph_.in_slot(static_cast<std::size_t>(*next))->id;
    decision.out = *way_out(graph_, *state_.at, *decision.to);
  } else if (intent.target.port < 0) {
    return end(Ending::trapped, "the rules come to a standstill: they want to go where the robot is");
  } else if (const auto far = graph_.other_end(intent.target)) {
    decision.to = far->indicator;
  }
  const bool walks = options_.explorer == ExplorerKind::random_walk || options_.explorer == ExplorerKind::tremaux;
  if (!walks && state_.idle > 2 * static_cast<int>(graph_.size()) + 10)
    return end(Ending::trapped, "the rules lead round in a circle in which nothing new is learnt");
  decision.direction = decision.out.port >= 0 ? graph_.port(decision.out).direction
                                              : motion_direction(graph_, decision.out, *decision.to);
  if (decision.out.port >= 0) graph_.pass(decision.out);
  state_.left_by = decision.out;
  return told(std::move(decision));
}

bool Explorer::spent(std::string& why) const {
  if (state_.in_run > options_.decisions)
    why = fmt::format("the budget of {} decisions is spent", options_.decisions);
  else if (options_.budget > 0 && state_.walked > options_.budget)
    why = fmt::format("the budget of {:g} m is spent", options_.budget);
  return !why.empty();
}

const Decision& Explorer::end(Ending ending, std::string reason) {
  Decision decision;
  decision.ending = ending;
  decision.reason = std::move(reason);
  decision.out = decision.target = {*state_.at};
  return told(std::move(decision));
}

const Decision& Explorer::told(Decision decision) {
  decision_ = std::move(decision);
  if (on_decision) on_decision(decision_);
  return decision_;
}

/// Opens all that is closed, once per run; false: nothing was.
bool Explorer::reopen_all() {
  if (std::exchange(state_.reopened, true)) return false;
  bool any = false;
  for (const IndicatorId id : graph_.ids())
    for (int p = 0; p < static_cast<int>(graph_.get(id).ports.size()); ++p) {
      const Port& port = graph_.port({id, p});
      if (port.misses >= options_.evidence) continue;  // seen closed, not found closed
      if (port.state != PortState::blocked && port.state != PortState::dead_end) continue;
      graph_.reopen({id, p});
      any = true;
    }
  return any;
}

void Explorer::find_ways() {
  if (links_revision_ != graph_.revision()) {
    links_ = RouteLinks(graph_);
    links_revision_ = graph_.revision();
  }
  from_here_.excite(links_, static_cast<int>(state_.at->slot), std::nullopt, options_.rows);
  from_start_.excite(links_, static_cast<int>(state_.start->slot), std::nullopt, options_.rows);
}

Situation Explorer::situation() const {
  return {.graph = graph_,
          .options = options_,
          .at = *state_.at,
          .came_by = state_.came_by,
          .goal = goal_,
          .at_goal = state_.at_goal,
          .from_here = from_here_.potentials(),
          .from_start = from_start_.potentials(),
          .decision = state_.decisions,
          .fresh = state_.fresh};
}

std::optional<Route> Explorer::route() const {
  if (!state_.start || !state_.at_goal) return std::nullopt;
  return neural_shortest_path(RouteLinks(graph_), static_cast<int>(state_.start->slot),
                              static_cast<int>(state_.at_goal->slot), options_.rows);
}

bool Explorer::proven() const {
  if (!state_.start || !state_.at_goal) return false;
  PathNetwork network;
  network.excite(RouteLinks(graph_), static_cast<int>(state_.start->slot), std::nullopt, NetworkRows::adaptive);
  Situation seen = situation();
  seen.at = *state_.start;
  seen.from_here = seen.from_start = network.potentials();
  if (!std::isfinite(seen.from_start[state_.at_goal->slot])) return false;
  bool better = false;
  for_unknown_ports(seen, [&](const PortRef& ref, const Port&) { better = better || may_shorten(seen, ref); });
  return !better;
}

bool Explorer::knows(const Vec2& position) const { return winner(graph_, position, options_.same).has_value(); }

void Explorer::restore(IndicatorGraph graph, const ExplorerState& state, Decision last) {
  for (const auto& id : {state.at, state.start, state.at_goal})
    if (id && !graph.alive(*id)) fail("explorer: indicator {} is not in the graph", id->slot + 1);
  if (state.left_by && state.left_by->port >= 0) graph.port(*state.left_by);
  graph_ = std::move(graph);
  state_ = state;
  decision_ = std::move(last);
  links_revision_ = ~std::uint64_t{0};
}

}  // namespace meander

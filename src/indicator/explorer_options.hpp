// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>

#include "base/fields.hpp"
#include "indicator/path_network.hpp"

namespace meander {

/// How strictly the explorer follows the paper's rules 3 and 4.
enum class ExplorerRules { literal, repaired, optimistic };
template <>
struct EnumNames<ExplorerRules> {
  static constexpr std::pair<ExplorerRules, const char*> entries[] = {{ExplorerRules::literal, "literal"},
                                                                      {ExplorerRules::repaired, "repaired"},
                                                                      {ExplorerRules::optimistic, "optimistic"}};
};

/// Who decides: the paper's rules, or one of those that they are compared with on the same graph.
enum class ExplorerKind { indicator, tremaux, depth_first, nearest, goal_frontier, random_walk };
template <>
struct EnumNames<ExplorerKind> {
  static constexpr std::pair<ExplorerKind, const char*> entries[] = {
      {ExplorerKind::indicator, "indicator"},         {ExplorerKind::tremaux, "tremaux"},
      {ExplorerKind::depth_first, "depth_first"},     {ExplorerKind::nearest, "nearest"},
      {ExplorerKind::goal_frontier, "goal_frontier"}, {ExplorerKind::random_walk, "random_walk"}};
};

struct ExplorerOptions {
  ExplorerKind explorer = ExplorerKind::indicator;
  ExplorerRules rules = ExplorerRules::optimistic;
  double eps = 0.01;
  double weight = 1;
  double step = 0.8;
  NetworkRows rows = NetworkRows::adaptive;
  double tolerance = 0.3;
  double same = 0.35;
  double match = 0.6;
  int evidence = 1;
  int tries = 2;
  int recheck = 3;
  int decisions = 1000000;
  double budget = 0;
  std::uint64_t seed = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ExplorerOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"explorer", "", "who decides: the indicators' rules, or a baseline on the same graph"}, o.explorer);
  visit(Field{"rules", "", "the paper's rules literally, repaired, or optimistic"}, o.rules);
  visit(Field{"eps", "", "stop looking when nothing unknown can shorten the route by more than this share", 0, 1},
        o.eps);
  visit(Field{"weight", "", "of the estimated way to the goal, until a route to it is known", 0, 100}, o.weight);
  visit(Field{"step", "m", "of a way that is not known, so much is taken to lead straight on", 0, 10}, o.step);
  visit(Field{"rows", "", "of the network: as many as the paper says, or as many as it takes"}, o.rows);
  visit(Field{"tolerance", "m", "the goal is reached when so near", 0.001, 100}, o.tolerance);
  visit(Field{"same", "m", "an indicator that is so near is the one here", 0.001, 100}, o.same);
  visit(Field{"match", "rad", "a port seen in a direction that is off by so little is the one stored", 0, 1.6},
        o.match);
  visit(Field{"evidence", "", "visits in a row without a port to be seen until it counts as closed", 1, 100},
        o.evidence);
  visit(Field{"tries", "", "failed approaches until a port is given up", 1, 100}, o.tries);
  visit(Field{"recheck", "", "runs until a closed way is tried again, twice as many each time; 0: never", 0, 1000},
        o.recheck);
  visit(Field{"decisions", "", "budget of a run", 1, 1e9}, o.decisions);
  visit(Field{"budget", "m", "budget of a run; 0: none", 0, 1e9}, o.budget);
  visit(Field{"seed", "", "of the random walk"}, o.seed);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>

#include "robot/contracts.hpp"
#include "topology/route.hpp"
#include "topology/topologic_map.hpp"
#include "topology/trail.hpp"

namespace meander::topology {

struct RouteGuideOptions {
  RouteOptions route;
  double near = 0.25;       ///< a place on the way counts as passed within this [m]
  double arrive = 0.12;     ///< the goal within this [m]
  double confirm = 0.2;     ///< a place this near to the goal [m] is as good when the senses are like the goal's ...
  double like = 0.8;        ///< ... up to this distance
  double pull = 0.4;        ///< share of the way to the place that the senses tell, when that is another
  int tries = 40;           ///< points around the goal where it looks
  double progress = 0.3;    ///< stuck when the wheels do not bring it this far [m] ...
  int patience = 60;        ///< ... in so many samples; the link is then given up
  int most_samples = 3000;  ///< for the whole way
  bool learn = false;       ///< go on learning while driving
  int recoveries = 5;       ///< how often a lost robot looks for itself in the whole map
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RouteGuideOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"route", "", "what links cost"}, o.route);
  visit(Field{"near", "m", "a place on the way counts as passed within this", 0.01, 10}, o.near);
  visit(Field{"arrive", "m", "the goal is reached within this", 0.01, 10}, o.arrive);
  visit(Field{"confirm", "m", "a place this near to the goal is as good when the senses are like the goal's", 0, 100},
        o.confirm);
  visit(Field{"like", "", "largest distance of senses that are like the goal's", 0, 100}, o.like);
  visit(Field{"pull", "", "share of the way to the place that the senses tell when that is another", 0, 1}, o.pull);
  visit(Field{"tries", "", "points around the goal where it looks", 0, 10000}, o.tries);
  visit(Field{"progress", "m", "stuck when the wheels do not bring it this far", 0.01, 10}, o.progress);
  visit(Field{"patience", "", "in so many samples", 1, 1e6}, o.patience);
  visit(Field{"most_samples", "", "for the whole way", 1, 1e9}, o.most_samples);
  visit(Field{"recoveries", "", "how often a lost robot looks for itself in the whole map", 0, 1000}, o.recoveries);
  visit(Field{"learn", "", "go on learning while driving"}, o.learn);
}

/// Drives over the links of the map to one of its places and believes to be there only when the senses agree. A link on
/// which the robot gets stuck is suspended, and after straying a little it plans anew; where the senses do not tell the
/// goal it looks about; a robot that finds no way, or no agreement, is lost and looks for its last stretch of way in
/// the whole map. The goal is a cell of the map now.
Guide route_guide(const std::shared_ptr<TopologicMap>& map, int goal, const RouteGuideOptions& options = {});

}  // namespace meander::topology

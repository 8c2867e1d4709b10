// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>
#include <optional>

#include "planning/plan.hpp"
#include "robot/contracts.hpp"
#include "robot/platform.hpp"

namespace meander {

struct PlannedRouteOptions {
  std::string planner = "neural_map";
  double robot_radius = 0.3;
  double margin = 0.1;
  double reach = 3;
  double hand_over = 0.6;
  double tolerance = 0.25;
  double detour = 3;
  int replans = 12;
  double trap_size = 0.5;
  double mapped = 0.2;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlannedRouteOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"planner", "", "who plans: neural_map, distance_transform, harmonic, astar or theta_star"}, o.planner);
  visit(Field{"robot_radius", "m", "of the robot's body", 0, 100}, o.robot_radius);
  visit(Field{"margin", "m", "kept from what is solid besides; given up where no path has it", 0, 100}, o.margin);
  visit(Field{"reach", "m", "a subgoal is at most this far ahead on the path, and in sight on the map", 0.1, 1000},
        o.reach);
  visit(Field{"hand_over", "m", "the next subgoal when this near", 0.01, 100}, o.hand_over);
  visit(Field{"tolerance", "m", "of the target", 0.01, 100}, o.tolerance);
  visit(Field{"detour", "m", "trapped is also who has driven this much more than the straight way to the subgoal", 0.1,
              1e6},
        o.detour);
  visit(Field{"replans", "", "so often a new path is planned because the robot was trapped", 0, 1000}, o.replans);
  visit(Field{"trap_size", "m", "side of the square that is taken as blocked where a trapped robot came no nearer",
              0.05, 10},
        o.trap_size);
  visit(Field{"mapped", "m", "what the sonars hear this near to something solid in the map is taken to be that", 0, 10},
        o.mapped);
}

/// [LM99] Figure 9: global planning hands landmarks to the local navigation. A path is planned on the map; its points
/// are the subgoals, each the farthest that is in sight from the robot. When the rest of the path is not clear any
/// more, in the map, which may be edited, or for what the sonars hear beside it, a new path is planned. So it is when
/// the navigator reports that it is trapped; what is just ahead is taken as blocked then. The guide sees the map it was
/// given, in the odometry frame, and observations; it hears by the ring of `robot` (none: not at all).
/// On large maps a plan takes seconds: `stop`, which lives as long as the guide, ends it with Cancelled.
Guide planned_route(std::shared_ptr<const PlanningMap> map, std::vector<Vec2> targets,
                    const PlannedRouteOptions& options = {}, const std::optional<Platform>& robot = std::nullopt,
                    const StopToken* stop = nullptr);

}  // namespace meander

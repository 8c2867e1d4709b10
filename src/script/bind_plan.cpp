// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/plan.hpp"

#include "render/draw_plan.hpp"
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/picture.hpp"
#include "script/plan_table.hpp"

/// A plan `p` from one end of a room to the other.
#define EXAMPLE_PLAN                                                                                                \
  "p = meander.planning.plan { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5, start = " \
  "{1, 1}, target = {7, 3} } "

namespace meander::script {

struct MeasuresView {
  double length = 0, turning = 0, curvature = 0, clearance_mean = 0, clearance_min = 0;
  int points = 0, fallbacks = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MeasuresView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"length", "m", "of the path"}, o.length);
  visit(Field{"turning", "rad", "sum of |change of direction|"}, o.turning);
  visit(Field{"curvature", "rad/m", "largest, between pieces of a cell's length"}, o.curvature);
  visit(Field{"clearance_mean", "m", "from what is solid and the rim, along the way"}, o.clearance_mean);
  visit(Field{"clearance_min", "m", "exactly, of all points of the path"}, o.clearance_min);
  visit(Field{"points", "", "of the path"}, o.points);
  visit(Field{"fallbacks", "", "steps to the best neighbour that the gradient needed"}, o.fallbacks);
}

struct StatisticsView {
  double cells = 0, relaxations = 0, dead_units = 0, residual = 0;
  bool complete = true;
  std::string solver;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, StatisticsView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"cells", "", "from which a target can be reached (landscapes)"}, o.cells);
  visit(Field{"relaxations", "", "updates of a cell's value, all together"}, o.relaxations);
  visit(Field{"dead_units", "", "reachable cells without a value that a path could follow"}, o.dead_units);
  visit(Field{"residual", "", "largest relative error of a cell's equation at the end"}, o.residual);
  visit(Field{"complete", "", "false: ended as soon as the start had what it needs"}, o.complete);
  visit(Field{"solver", "", "the one that ran: tiles leaves mazes, terrain and other lattices to active_list"},
        o.solver);
}

namespace {

Planned plan(const PlanTable& table, const Call& call) {
  const PlanningTask task = task_of(table.task, table.source.world.get());
  const auto map = map_of(table.source, call.work());
  return or_reason(std::make_shared<Plan>(
      make_plan(problem_on(*map, task, call.work()), table.planner, table.planners, table.task.path, call.work())));
}

Planned from(const Plan& plan, const Vec2& start, const std::optional<PathKind>& kind, const Call& call) {
  if (!plan.result.way.empty()) fail("planner '{}' has no landscape: plan anew from another start", plan.planner);
  const Cell cell = cell_at(plan.problem.lattice, plan.problem.blocked.frame.in_cells(start));
  if (!plan.result.statistics.complete && cell != plan.problem.start)
    fail("the landscape was solved for the start of this plan alone: plan anew from another, or with extent = 'map'");
  auto other = std::make_shared<Plan>(plan);
  other->problem.start = cell;
  other->kind = kind.value_or(plan.kind);
  // The landscape knows who is cut off; only what has no value there asks for the reason.
  other->result.reason =
      plan.result.value.at(cell, kNoValue) == kNoValue ? no_path_reason(other->problem, call.work()) : std::string();
  find_path(*other, call.work());
  return or_reason(std::move(other));
}

MeasuresView measures(const Plan& plan) {
  const double cell = plan.resolution();
  const PathMeasures& m = plan.measures;
  return {m.length * cell,        m.turning,
          m.curvature / cell,     m.clearance_mean * cell,
          m.clearance_min * cell, static_cast<int>(plan.path.points.size()),
          plan.path.fallbacks};
}

StatisticsView statistics(const Plan& plan) {
  const PlanningStatistics& s = plan.result.statistics;
  return {static_cast<double>(s.cells),
          static_cast<double>(s.relaxations),
          static_cast<double>(s.dead_units),
          s.residual,
          s.complete,
          s.solver};
}

std::optional<double> value(const Plan& plan, double x, double y) {
  const double value = plan.value({x, y});
  return value == kNoValue ? std::nullopt : std::optional(value);
}

Matrix landscape(const Plan& plan) {
  const Grid<double>& value = plan.result.value;
  return {std::make_shared<std::vector<float>>(value.cells().begin(), value.cells().end()),
          static_cast<std::size_t>(value.height()), static_cast<std::size_t>(value.width())};
}

std::vector<Vec2> path(const Plan& plan) { return plan.points(); }

std::string text(const Plan& plan) {
  const MeasuresView m = measures(plan);
  if (plan.path.points.empty())
    return fmt::format("plan: {}, no start, {} cells reach a target", plan.planner, plan.result.statistics.cells);
  return fmt::format("plan: {}, {:.2f} m, turning {:.2f} rad, clearance {:.2f} m, {}", plan.planner, m.length,
                     m.turning, m.clearance_min, plan.clear ? "clear" : "NOT clear");
}
DrawList picture(const Plan& plan) { return draw_plan(plan, theme(Background::light)); }

void bind_module(lua_State* L) {
  Module(L, "meander.planning", "")
      .function<&plan>(Doc{.name = "plan",
                           .text = "Plans a path on a map of cells.",
                           .args = {{"options", "the map, where from, where to, and who plans how"}},
                           .returns = "the plan; or nil and why there is no path",
                           .returns_type = "plan or nil, string or nil",
                           .errors = "no target; an unknown planner; a number out of range",
                           .example = EXAMPLE_PLAN "print(p)"})
      .function<&planner_names>(Doc{.name = "planners",
                                    .text = "The names that plan takes as planner.",
                                    .returns = "list of names",
                                    .example = "print(meander.planning.planners()[1])"});
}

}  // namespace

void bind_plan(lua_State* L) {
  bind_module(L);
  Type<Plan>(L, "A path, and the landscape that it was found on.")
      .method<&from>(
          Doc{.name = "from",
              .text = "A path on the same landscape from another start, or read off in another way.",
              .args = {{"start", "where from", "m"}, {"kind", "how it is read off; as before when left out"}},
              .returns = "the plan; or nil and why there is no path",
              .returns_type = "plan or nil, string or nil",
              .errors = "a plan of a search, which has no landscape; another start than that of an extent = 'start'",
              .example = EXAMPLE_PLAN "print(p:from({1, 3}, 'steepest'))"})
      .method<&value>(Doc{.name = "value",
                          .text =
                              "The landscape at a point: ln v of a neural map, minus the cost that is left [cells], "
                              "or the logarithm of a harmonic function.",
                          .args = {{"x", "where", "m"}, {"y", "where", "m"}},
                          .returns = "the value; nil where there is none",
                          .example = EXAMPLE_PLAN "print(p:value(2, 2))"})
      .method<&landscape>(Doc{.name = "landscape",
                              .text = "All values in single precision, the lowest row first; -inf where there is none.",
                              .returns = "a matrix",
                              .example = EXAMPLE_PLAN "print(p:landscape().rows)"})
      .property<&path>(PropertyDoc{.name = "path",
                                   .text = "The points of the path, from the start's cell to the target's.",
                                   .unit = "m",
                                   .example = EXAMPLE_PLAN "print(#p.path, p.path[1].x)"})
      .property<&measures>(PropertyDoc{.name = "measures",
                                       .text = "What the path is like: length, turning, curvature, clearance.",
                                       .example = EXAMPLE_PLAN "print(p.measures.length)"})
      .property<&statistics>(
          PropertyDoc{.name = "statistics",
                      .text = "What the planner did: cells, relaxations, dead_units, residual, solver.",
                      .example = EXAMPLE_PLAN "print(p.statistics.relaxations)"})
      .property<&Plan::clear>(PropertyDoc{.name = "clear",
                                          .text = "For certain the whole path keeps the robot's body clear of all that "
                                                  "is solid.",
                                          .example = EXAMPLE_PLAN "print(p.clear)"})
      .property<&Plan::planner>(
          PropertyDoc{.name = "planner", .text = "Who planned it.", .example = EXAMPLE_PLAN "print(p.planner)"})
      .text<&text>()
      .picture<&picture>();
}

}  // namespace meander::script

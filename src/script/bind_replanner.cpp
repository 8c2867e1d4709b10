// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_replanner.hpp"

#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/plan_table.hpp"

/// A replanner `r` on a map `m`.
#define EXAMPLE_REPLANNER                                                                                   \
  "m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 0.5 } " \
  "r = meander.planning.replanner { map = m, start = {1, 1}, target = {7, 1} } "

namespace meander::script {

/// A neural map that follows the edits of the map it was made for.
struct Replanner {
  std::shared_ptr<const PlanningMap> map;
  PlanningTask task;
  PathKind kind = PathKind::gradient;
  NeuralMapOptions options;
  NeuralReplanner neural;
};
template <>
struct ObjectName<Replanner> {
  static constexpr const char* value = "replanner";
};
inline std::size_t native_size(const Replanner& r) { return 100 * r.neural.problem().blocked.cells().size(); }

/// Of a neural map only what following edits has a use for.
struct ReplannerTable {
  Required<std::shared_ptr<PlanningMap>> map;
  TaskTable task;
  NeuralMapOptions neural_map;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ReplannerTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"map", "", "a map of meander.planning.map or read_map, whose edits are followed"}, o.map);
  fields(o.task, visit);
  fields(o.neural_map, [&](const Field& field, auto& member) {
    const std::string_view name = field.name;
    if (name != "extent" && name != "extra_patterns") visit(field, member);
  });
}

namespace {

std::shared_ptr<Replanner> make(const ReplannerTable& table, const Call& call) {
  const PlanningTask task = task_of(table.task, nullptr);
  const PlanningMap& map = *table.map.value;
  return std::make_shared<Replanner>(
      Replanner{table.map.value, task, table.task.path, table.neural_map,
                NeuralReplanner(problem_on(map, task, call.work()), table.neural_map, call.work())});
}

/// The cells that are blocked now and were free, or the other way round.
std::vector<CellEdit> edits_between(const Grid<std::uint8_t>& before, const Grid<std::uint8_t>& now) {
  std::vector<CellEdit> edits;
  for (int y = 0; y < now.height(); ++y)
    for (int x = 0; x < now.width(); ++x)
      if (before[{x, y}] != now[{x, y}]) edits.push_back({{x, y}, now[{x, y}] != 0});
  return edits;
}

Planned replan(Replanner& replanner, const Call& call) {
  PlanningProblem now = problem_on(*replanner.map, replanner.task, call.work());
  const PlanningProblem& before = replanner.neural.problem();
  if (before.difficulty == now.difficulty && before.drag == now.drag)
    replanner.neural.edit(edits_between(before.blocked, now.blocked), call.work());
  else
    replanner.neural = NeuralReplanner(now, replanner.options, call.work());
  auto plan = std::make_shared<Plan>(Plan{.planner = "neural_map",
                                          .kind = replanner.kind,
                                          .problem = std::move(now),
                                          .result = replanner.neural.landscape(call.work())});
  plan->result.statistics.relaxations = replanner.neural.last_relaxations();
  plan->result.reason = no_path_reason(plan->problem, call.work());
  if (plan->problem.start) find_path(*plan, call.work());
  return or_reason(std::move(plan));
}

double relaxations(const Replanner& replanner) { return static_cast<double>(replanner.neural.last_relaxations()); }

std::string text(const Replanner& replanner) {
  return fmt::format("replanner: {} x {} cells", replanner.map->solid.width(), replanner.map->solid.height());
}

}  // namespace

void bind_replanner(lua_State* L) {
  Module(L, "meander.planning", "")
      .function<&make>(Doc{.name = "replanner",
                           .text =
                               "A neural map that follows the edits of its map: only what changes is computed (with "
                               "difficulty or drag, all), and the landscape is that of a solve from scratch, to "
                               "the tolerance.",
                           .args = {{"options", "the map, where from and where to, and how"}},
                           .returns = "the replanner",
                           .errors = "no map, no target; a number out of range; the solvers raster and synchronous",
                           .example = EXAMPLE_REPLANNER "print(r)"});
  Type<Replanner>(L, "A neural map that follows the edits of its map.")
      .method<&replan>(
          Doc{.name = "replan",
              .text = "The plan on the map as it is now; its statistics tell the updates of this edit alone.",
              .returns = "the plan; or nil and why there is no path",
              .returns_type = "plan or nil, string or nil",
              .example = EXAMPLE_REPLANNER "m:block {{3, 0}, {4, 3}} print(r:replan())"})
      .property<&relaxations>(
          PropertyDoc{.name = "relaxations",
                      .text = "Updates of a cell's value that the last replan needed; before it, the first solve.",
                      .example = EXAMPLE_REPLANNER "print(r.relaxations) r:replan() print(r.relaxations)"})
      .text<&text>();
}

}  // namespace meander::script

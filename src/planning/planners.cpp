// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/planners.hpp"

#include "base/names.hpp"
#include "planning/astar.hpp"
#include "planning/distance_transform.hpp"
#include "planning/harmonic.hpp"
#include "planning/neural_map.hpp"
#include "planning/theta_star.hpp"

namespace meander {
namespace {

using Planner = PlanningResult (*)(const PlanningProblem&, const PlannerOptions&, const Work&);

/// A planner that has no options.
template <PlanningResult (*F)(const PlanningProblem&, const Work&)>
PlanningResult plain(const PlanningProblem& problem, const PlannerOptions&, const Work& work) {
  return F(problem, work);
}

PlanningResult by_neural_map(const PlanningProblem& problem, const PlannerOptions& options, const Work& work) {
  return neural_map(problem, options.neural_map, work);
}

PlanningResult by_harmonic(const PlanningProblem& problem, const PlannerOptions& options, const Work& work) {
  return harmonic(problem, options.harmonic, work);
}

constexpr std::pair<const char*, Planner> kPlanners[] = {{"neural_map", by_neural_map},
                                                         {"distance_transform", plain<distance_transform>},
                                                         {"harmonic", by_harmonic},
                                                         {"astar", plain<astar>},
                                                         {"theta_star", plain<theta_star>}};

Planner planner_by_name(const std::string& name) {
  for (const auto& [known, planner] : kPlanners)
    if (name == known) return planner;
  fail("unknown planner '{}'{} (known: {})", name, did_you_mean(name, planner_names()), listing(planner_names()));
}

bool length_alone(Planner planner) { return planner == by_harmonic || planner == plain<theta_star>; }

[[noreturn]] void fail_uneven(const std::string& name) {
  fail("planner '{}': no difficulty and no drag expected: it takes length for cost", name);
}

/// What only some can do.
void check_supported(const PlanningProblem& problem, const std::string& name, Planner planner) {
  if (!length_alone(planner)) return;
  if (problem.lattice != Lattice::rectangular)
    fail("planner '{}': lattice 'rectangular' expected, got '{}'", name, to_string(problem.lattice));
  if (!problem.even()) fail_uneven(name);
  if (planner == by_harmonic && problem.corners != Corners::keep)
    fail("planner '{}': corners 'keep' expected, got '{}': its walks take no diagonal steps", name,
         to_string(problem.corners));
}

}  // namespace

void check_planner(const std::string& name, bool even) {
  const Planner planner = planner_by_name(name);
  if (!even && length_alone(planner)) fail_uneven(name);
}

PlanningResult solve(const PlanningProblem& problem, const std::string& planner, const PlannerOptions& options,
                     const Work& work) {
  const Planner chosen = planner_by_name(planner);
  validate(options.neural_map);
  validate(options.harmonic);
  check_supported(problem, planner, chosen);
  // A search finds out by itself whether a way leads there, and a neural map asks.
  const bool by_itself = chosen == plain<astar> || chosen == plain<theta_star> || chosen == by_neural_map;
  std::string reason = by_itself ? bad_place_reason(problem) : no_path_reason(problem, work);
  if (!reason.empty()) return {.value = {}, .reason = std::move(reason)};
  return chosen(problem, options, work);
}

std::vector<std::string> planner_names() {
  std::vector<std::string> names;
  for (const auto& [name, planner] : kPlanners) names.emplace_back(name);
  return names;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/kit_options.hpp"
#include "script/map_object.hpp"
#include "script/numbers.hpp"
#include "script/objects.hpp"
#include "study/map_score.hpp"

/// A map `m` and the simulation `s` whose one scan it has taken in.
#define EXAMPLE_SCORED                                                                                              \
  "w = meander.world.new { start = {2, 2, 0} } w:add_disc { center = {3, 2}, radius = 0.3 } s = meander.sim.new { " \
  "world = w } m = "                                                                                                \
  "meander.mapping.map { model = 'elfes' } m:update(s.observation) "

namespace meander {

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ReliabilityBin>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"weight", "", "of its cells; all bins together 1"}, o.weight);
  visit(Field{"predicted", "", "sum of their probabilities, weighted"}, o.predicted);
  visit(Field{"occupied", "", "weight of those that are occupied"}, o.occupied);
}

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapScore>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"free", "", "cells seen that are free"}, o.free);
  visit(Field{"occupied", "", "cells seen that are occupied"}, o.occupied);
  visit(Field{"ce", "", "cross-entropy in nats; a coin has 0.693"}, o.ce);
  visit(Field{"brier", "", "mean squared error of the probability"}, o.brier);
  visit(Field{"auc", "", "share of pairs of an occupied and a free cell in right order"}, o.auc);
  visit(Field{"ece", "", "expected calibration error"}, o.ece);
  visit(Field{"error", "m", "mean error of the distance to the first obstacle, over the directions"}, o.error);
  visit(Field{"missed", "", "share of the directions whose obstacle the map does not show"}, o.missed);
  visit(Field{"phantom", "", "share of the directions without an obstacle where the map shows one"}, o.phantom);
  visit(Field{"reliability", "", "the bins of the reliability curve"}, o.reliability);
}

}  // namespace meander

namespace meander::script {
namespace {

MapScore score(const SonarMap& map, const Sim& sim, const std::optional<MapScoreOptions>& options) {
  return score_map(map.probabilities(MapPart::local), sim, 0, options.value_or(MapScoreOptions{}));
}

Matrix truth(const SonarMap& map, const Sim& sim, const std::optional<MapTruthOptions>& options) {
  const Grid<float> window = map.local().log_odds();
  const Grid<CellTruth> truth =
      map_truth(sim, 0, window.width(), window.height(), window.frame, options.value_or(MapTruthOptions{}));
  auto cells = std::make_shared<std::vector<float>>();
  for (const CellTruth cell : truth.cells()) cells->push_back(static_cast<float>(cell));
  return {std::move(cells), static_cast<std::size_t>(window.height()), static_cast<std::size_t>(window.width())};
}

}  // namespace

void bind_map_score(lua_State* L) {
  Module(L, "meander.study", "")
      .function<&score>(Doc{.name = "map_score",
                            .text = "How good the local map of the first robot is, on the cells that it sees from "
                                    "where it is; both classes weigh the same. Odometry must not drift.",
                            .args = {{"map", "which"}, {"sim", "the truth"}, {"options", "how it is scored"}},
                            .returns = "table of figures",
                            .errors = "an option out of range",
                            .example = EXAMPLE_SCORED "print(meander.study.map_score(m, s).error)"})
      .function<&truth>(Doc{.name = "map_truth",
                            .text = "What the cells of the local map truly are for the first robot: 0 hidden, 1 free, "
                                    "2 occupied, in the shape of map:matrix 'local'.",
                            .args = {{"map", "which"}, {"sim", "the truth"}, {"options", "what counts as seen"}},
                            .returns = "the truth",
                            .errors = "an option out of range",
                            .example = EXAMPLE_SCORED "print(meander.study.map_truth(m, s):all():max())"});
}

}  // namespace meander::script

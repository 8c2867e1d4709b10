// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"
#include "script/topology_objects.hpp"
#include "study/place_scores.hpp"

#define EXAMPLE_SCORES                                                                                         \
  "s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice' } m = "          \
  "meander.topology.map {} p = meander.study.place_scores(s) s:drive { navigator = meander.topology.whiskers " \
  "{}, guide = meander.topology.wander { map = m, samples = 300 }, on_step = function() p:add(m) end } "

namespace meander {

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlaceSummary>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"samples", "", "scored"}, o.samples);
  visit(Field{"error_mean", "m", "mean distance between believed and true position"}, o.error_mean);
  visit(Field{"error_max", "m", "largest"}, o.error_max);
  visit(Field{"error_last", "m", "mean over the last 1000 samples"}, o.error_last);
  visit(Field{"error_aligned", "m", "root mean square after the best turn and shift of the whole"}, o.error_aligned);
  visit(Field{"recall", "", "share of the returns to a place that were recognised"}, o.recall);
  visit(Field{"precision", "", "share of the recognitions that were right"}, o.precision);
}

}  // namespace meander

namespace meander::script {

/// The scores hold the simulation whose truth they know.
struct ScoredSim {
  std::shared_ptr<Sim> sim;
  PlaceScores scores;
};
template <>
struct ObjectName<ScoredSim> {
  static constexpr const char* value = "place_scores";
};

namespace {

std::shared_ptr<ScoredSim> make(const std::shared_ptr<Sim>& sim, const std::optional<PlaceScoreOptions>& options) {
  return std::make_shared<ScoredSim>(ScoredSim{sim, PlaceScores(*sim, options.value_or(PlaceScoreOptions{}))});
}
void add(ScoredSim& scored, const topology::TopologicMap& map) {
  const topology::Recognition& said = map.recognition();
  PlaceClaim claim;
  if (map.net().cells().alive(said.cell)) {
    const topology::Cell& cell = map.net().cells()[said.cell];
    claim = {said.sample, cell.serial, cell.born};
  }
  scored.scores.add(*scored.sim, map.pose(), claim);
}
PlaceSummary summary(const ScoredSim& scored) { return scored.scores.summary(); }
double map_error(const ScoredSim& scored, const topology::TopologicMap& map) {
  std::vector<PlaceScores::MapPlace> places;
  const topology::CellPool& cells = map.net().cells();
  for (int cell = 0; cell < cells.slots(); ++cell)
    if (cells.alive(cell)) places.push_back({cells[cell].serial, cells[cell].position});
  return scored.scores.map_error(places);
}
std::optional<Vec2> true_place(const ScoredSim& scored, const topology::TopologicMap& map, int number) {
  return scored.scores.true_place(map.net().cells()[cell_of(map, number)].serial);
}

}  // namespace

void bind_place_scores(lua_State* L) {
  Module(L, "meander.study", "")
      .function<&make>(Doc{.name = "place_scores",
                           .text = "Scores how well a topologic map knows places. Begin it before the first cycle.",
                           .args = {{"sim", "the simulation whose truth counts"}, {"options", "what counts as right"}},
                           .returns = "the scores",
                           .errors = "a number out of range",
                           .example = EXAMPLE_SCORES "print(p:summary().recall)"});
  Type<ScoredSim>(L, "How well a robot that builds a map of places knows where it is.")
      .method<&add>(Doc{.name = "add",
                        .text = "A cycle has ended; call it from on_step.",
                        .args = {{"map", "the map that took in the observation before the cycle"}},
                        .example = EXAMPLE_SCORES "p:add(m)"})
      .method<&summary>(Doc{.name = "summary",
                            .text = "Errors of the believed position, recall and precision of places.",
                            .returns = "table",
                            .example = EXAMPLE_SCORES "print(p:summary().error_mean)"})
      .method<&map_error>(Doc{.name = "map_error",
                              .text = "How far the places of a map lie from where they truly are: root mean square.",
                              .args = {{"map", "the map"}},
                              .returns = "the error in metres; 0 when no place ever won",
                              .example = EXAMPLE_SCORES "print(p:map_error(m))"})
      .method<&true_place>(Doc{.name = "true_place",
                               .text = "Where the robot truly was on average when a place won.",
                               .args = {{"map", "the map"}, {"number", "of the place"}},
                               .returns = "the position, or nil when it never won",
                               .errors = "no such place",
                               .example = EXAMPLE_SCORES "print(p:true_place(m, m.winner).x)"});
}

}  // namespace meander::script

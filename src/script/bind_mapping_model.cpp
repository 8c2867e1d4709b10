// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/model_object.hpp"
#include "script/robot_options.hpp"
#include "script/values.hpp"

namespace meander::script {

struct ModelTable {
  Preset<Platform> robot;
  SonarModelOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ModelTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot whose sonars are read"}, o.robot);
  fields(o.options, visit);
}

struct ScoreView {
  double ce = 0, brier = 0, auc = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ScoreView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"ce", "nat", "mean cross-entropy; 0.693: a coin"}, o.ce);
  visit(Field{"brier", "", "mean squared error of the probability"}, o.brier);
  visit(Field{"auc", "", "share of pairs of an occupied and a free cell in right order"}, o.auc);
}

namespace {

std::shared_ptr<SonarModel> make(const ModelOption& what, const ModelTable& table) {
  SonarModelOptions options = table.options;
  options.ring = table.robot.value.sonar;
  return std::make_shared<SonarModel>(what.make(options));
}

std::vector<double> evaluate(const SonarModel& model, const Values& ranges, const std::vector<Vec2>& cells,
                             const std::optional<double>& range_max) {
  if (ranges.list.size() != static_cast<std::size_t>(model.ring.count))
    fail("argument 'ranges': {} numbers expected, one for each sonar, got {}", model.ring.count, ranges.list.size());
  std::vector<float> range, bearing, log_odds(cells.size());
  for (const Vec2& cell : cells) {
    range.push_back(static_cast<float>(cell.norm()));
    bearing.push_back(static_cast<float>(angle_of(cell.y(), cell.x())));
  }
  model.evaluate({ranges.list, range_max.value_or(SonarSweep{}.range_max)}, {range, bearing}, log_odds);
  return {log_odds.begin(), log_odds.end()};
}

ScoreView score(const SonarModel& model, const SonarLessons& lessons, const Call& call) {
  const NetworkScore score = model_score(model, lessons, call.work());
  return {score.cross_entropy, score.brier, score.auc};
}

std::string text(const SonarModel& model) {
  return fmt::format("sonar_model: {} for a ring of {}", model.name, model.ring.count);
}

}  // namespace

void bind_mapping_model(lua_State* L) {
  Module(L, "meander.mapping", "")
      .function<&make>(Doc{
          .name = "model",
          .text = "A sensor model: what one scan tells about cells. By name, from a network, or a function of one's "
                  "own: it is given the ranges and lists of the cells' ranges [m] and bearings [rad] from the robot, "
                  "and returns a list of log-odds.",
          .args = {{"what", "a name that models() tells, a network, or a function"}, {"options", "what it is for"}},
          .returns = "the model, as meander.mapping.map takes it",
          .errors = "an unknown name; no weights for this sonar; another ring",
          .example = "print(meander.mapping.model('nn4', { preset = 'real' }))"});
  Type<SonarModel>(L, "A sensor model: what one scan tells about cells.")
      .method<&evaluate>(Doc{.name = "evaluate",
                             .text = "What a scan tells about places; log-odds l are the probability 1 / (1 + "
                                     "exp(-l)), 0 is unknown.",
                             .args = {{"ranges", "one for each sonar, in ring order", "m"},
                                      {"cells", "places in the frame of the robot", "m"},
                                      {"range_max", "the range that stands for no echo; 6.477 when left out", "m"}},
                             .returns = "list of the log-odds of each being occupied",
                             .errors = "another number of ranges",
                             .example =
                                 "ranges = {} for i = 1, 16 do ranges[i] = 1.5 end "
                                 "print(meander.mapping.model('nn4'):evaluate(ranges, { {1, 0}, {1.75, 0} })[1])"})
      .method<&score>(Doc{.name = "score",
                          .text = "How well single scans tell occupied from free; both classes weigh the same.",
                          .args = {{"lessons", "scans with cells whose truth is known"}},
                          .returns = "table of figures",
                          .errors = "lessons of another ring, or without cells of both kinds",
                          .example =
                              "l = meander.mapping.lessons { worlds = { meander.world.open 'worlds/office.toml' }, "
                              "poses = 4 } print(meander.mapping.model('elfes'):score(l).ce)"})
      .property<&SonarModel::name>(
          PropertyDoc{.name = "name", .text = "Its name.", .example = "print(meander.mapping.model('ros').name)"})
      .property<&SonarModel::reach>(PropertyDoc{.name = "reach",
                                                .text = "It says nothing about cells farther away.",
                                                .unit = "m",
                                                .example = "print(meander.mapping.model('nn4').reach)"})
      .text<&text>();
}

}  // namespace meander::script

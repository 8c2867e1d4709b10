// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/network_file.hpp"
#include "render/plot.hpp"
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/live_view.hpp"
#include "script/model_object.hpp"
#include "script/objects.hpp"
#include "script/robot_options.hpp"
#include "study/sonar_lessons.hpp"

/// Lessons `l` from a few places of the office.
#define EXAMPLE_LESSONS \
  "l = meander.mapping.lessons { worlds = { meander.world.open 'worlds/office.toml' }, poses = 5 } "
/// A network `n` that has learnt little from them.
#define EXAMPLE_NETWORK EXAMPLE_LESSONS "n = meander.mapping.train { lessons = l, hidden = {4}, epochs = 2 } "

namespace meander::script {

struct LessonsTable {
  Required<std::vector<std::shared_ptr<World>>> worlds;
  Preset<Platform> robot;
  Preset<SonarOptions> sonar;
  LessonOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LessonsTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"worlds", "", "in which the robot looks around"}, o.worlds);
  visit(Field{"robot", "", "kind of robot: its body and where its sonars sit"}, o.robot);
  visit(Field{"sonar", "", "model of the sonars, by name or in detail"}, o.sonar);
  fields(o.options, visit);
}

struct TrainTable {
  Required<std::shared_ptr<SonarLessons>> lessons;
  std::optional<std::shared_ptr<SonarLessons>> validation;
  std::string network = "nn4";
  TrainingOptions training;
  std::optional<Function> on_epoch;
  bool show = false;
  std::string sonar, made_by;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TrainTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"lessons", "", "what to learn from"}, o.lessons);
  visit(Field{"validation", "", "what to measure on after each epoch, from other worlds"}, o.validation);
  visit(Field{"network", "", "what it is told: 'nn1', 'nn2', 'nn3' of the paper, 'nn4' or 'nn5'"}, o.network);
  fields(o.training, visit);
  visit(Field{"on_epoch", "", "function(epoch) called after each: epoch, epochs, training, validation"}, o.on_epoch);
  visit(Field{"show", "", "shows the loss on the terminal while it learns"}, o.show);
  visit(Field{"sonar", "", "for the file: the sonar that it is for, in words"}, o.sonar);
  visit(Field{"made_by", "", "for the file: what made it, in words"}, o.made_by);
}

struct EpochView {
  int epoch = 0, epochs = 0;
  double training = 0, validation = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, EpochView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"epoch", "", "which, 1 first"}, o.epoch);
  visit(Field{"epochs", "", "how many there will be"}, o.epochs);
  visit(Field{"training", "nat", "cross-entropy while it learnt"}, o.training);
  visit(Field{"validation", "nat", "cross-entropy afterwards on the validation lessons; 0 without"}, o.validation);
}

namespace {

std::shared_ptr<SonarLessons> look_around(const LessonsTable& table, const Call& call) {
  if (table.worlds.value.empty()) fail("option 'worlds': at least one expected, got {{}}");
  auto lessons = std::make_shared<SonarLessons>();
  RobotOptions robot;
  robot.platform = table.robot.value;
  robot.sonar = table.sonar.value;
  const auto count = static_cast<double>(table.worlds.value.size());
  Work work = call.work();
  for (std::size_t i = 0; i < table.worlds.value.size(); ++i) {
    LessonOptions options = table.options;
    options.seed = trial_seed(options.seed, i);
    Work part{work.stop, {}};
    if (work.progress)
      part.progress = [&](double done, std::string_view label) {
        work.report((static_cast<double>(i) + done) / count, label);
      };
    add_lessons(*lessons, *table.worlds.value[i], robot, options, part);
  }
  return lessons;
}

/// The losses after each epoch, drawn on the terminal as they come.
class LossCurve {
 public:
  LossCurve(const Call& call, bool live) {
    if (live) view_.emplace(call, 0, 20, [this] { return losses_.empty() ? std::nullopt : std::optional(picture()); });
  }
  void add(const TrainingEpoch& epoch) {
    losses_.push_back(epoch.validation > 0 ? epoch.validation : epoch.training);
    if (view_) view_->next(picture(), fmt::format("epoch {} of {}: {:.4f}", epoch.epoch, epoch.epochs, losses_.back()));
  }

 private:
  DrawList picture() const { return draw_curve(losses_, {.title = "", .x = "epoch", .y = "cross-entropy [nat]"}); }
  std::vector<double> losses_;
  std::optional<LiveView> view_;
};

std::shared_ptr<SonarNetwork> train(const TrainTable& table, const Call& call) {
  check_words("option 'sonar'", table.sonar);
  check_words("option 'made_by'", table.made_by);
  LossCurve curve(call, table.show);
  const SonarLessons none{};
  auto network = std::make_shared<SonarNetwork>(train_sonar_network(
      table.network, sonar_features(table.network), *table.lessons.value, table.validation ? **table.validation : none,
      table.training, call.work(), [&](const TrainingEpoch& epoch) {
        curve.add(epoch);
        if (table.on_epoch)
          table.on_epoch->call(EpochView{epoch.epoch, epoch.epochs, epoch.training, epoch.validation});
      }));
  network->provenance = {table.sonar, table.made_by};
  return network;
}

std::shared_ptr<SonarNetwork> open(const InputFile& file) {
  return std::make_shared<SonarNetwork>(read_network(file.path));
}
void save(const SonarNetwork& network, const OutputFile& file) { write_network(network, file.path); }
std::vector<int> layers(const SonarNetwork& network) { return network.network.layers; }
std::string sonar(const SonarNetwork& network) { return network.provenance.sonar; }
std::string made_by(const SonarNetwork& network) { return network.provenance.made_by; }
std::string network_line(const SonarNetwork& network) {
  return fmt::format("sonar_network: {}, layers {}, for a ring of {}", network.name,
                     fmt::join(network.network.layers, "-"), network.ring.count);
}

int cells(const SonarLessons& lessons) { return static_cast<int>(lessons.cells.size()); }
int scans(const SonarLessons& lessons) { return static_cast<int>(lessons.scans()); }
std::string lessons_line(const SonarLessons& lessons) {
  return fmt::format("lessons: {} cells around {} scans", cells(lessons), scans(lessons));
}

void bind_network(lua_State* L) {
  Type<SonarNetwork>(L, "A network that reads a sonar ring.")
      .method<&save>(Doc{.name = "save",
                         .text = "Writes the weights as text, with a checksum.",
                         .args = {{"path", "a name with the suffix .txt"}},
                         .errors = "the file cannot be written",
                         .example = EXAMPLE_NETWORK "n:save 'mine.txt' print(meander.mapping.network 'mine.txt')"})
      .property<&SonarNetwork::name>(
          PropertyDoc{.name = "name",
                      .text = "What it is told about a cell, by its name.",
                      .example = "print(meander.mapping.network('models/nn4_real.txt').name)"})
      .property<&layers>(PropertyDoc{.name = "layers",
                                     .text = "Units of each layer, the inputs first.",
                                     .example = EXAMPLE_NETWORK "print(table.concat(n.layers, '-'))"})
      .property<&sonar>(PropertyDoc{.name = "sonar",
                                    .text = "The sonar that it was trained for, in words.",
                                    .example = "print(meander.mapping.network('models/nn4_real.txt').sonar)"})
      .property<&made_by>(PropertyDoc{.name = "made_by",
                                      .text = "What made it, with the seed, in words.",
                                      .example = "print(meander.mapping.network('models/nn4_real.txt').made_by)"})
      .text<&network_line>();
}

}  // namespace

void bind_mapping_train(lua_State* L) {
  Module(L, "meander.mapping", "")
      .function<&look_around>(
          Doc{.name = "lessons",
              .text = "Puts a robot at random free poses of worlds, reads its sonars there, and notes cells around it: "
                      "occupied, free, or hidden from its sight. Networks learn from that, and models are measured by "
                      "it. Of each kind a share is taken.",
              .args = {{"options", "the worlds, the robot with its sonars, how many poses and cells"}},
              .returns = "the lessons",
              .errors = "no world; a world without room; a number out of range",
              .example = EXAMPLE_LESSONS "print(l)"})
      .function<&train>(
          Doc{.name = "train",
              .text = "Trains a network from random weights; the same lessons and options give the same.",
              .args = {{"options", "the lessons, the kind of network and how it learns"}},
              .returns = "the network",
              .errors = "lessons without occupied or free cells; a number out of range; words of several lines",
              .example = EXAMPLE_NETWORK "print(meander.mapping.model(n):score(l).ce)"})
      .function<&open>(Doc{.name = "network",
                           .text = "Reads the weights of a network, e.g. of one that comes with the program.",
                           .args = {{"path", "a .txt file"}},
                           .returns = "the network",
                           .errors = "no such file; a file cut short or damaged, weights that are no numbers, layers "
                                     "that do not fit",
                           .example = "print(meander.mapping.network 'models/nn4_ideal.txt')"});
  bind_network(L);
  Type<SonarLessons>(L, "Scans with cells around the robot whose truth is known.")
      .property<&scans>(PropertyDoc{.name = "scans", .text = "How many.", .example = EXAMPLE_LESSONS "print(l.scans)"})
      .length<&cells>()
      .text<&lessons_line>();
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/sonar_network.hpp"

#include <algorithm>
#include <memory>

#include "base/data_folder.hpp"
#include "base/names.hpp"
#include "base/visible_text.hpp"
#include "mapping/network_file.hpp"

namespace meander {
namespace {

using mapping::Block, mapping::kBlock, mapping::kLanes, mapping::Lanes;

/// Everything that one model needs from scan to scan.
struct Reader {
  explicit Reader(const SonarNetwork& made)
      : selector(made.ring, made.features), pass(made.network), prior(static_cast<float>(made.prior)) {}

  void evaluate(const SonarSweep& sweep, const CellPlaces& cells, std::span<float> log_odds) {
    selector.take(sweep);
    const float reach = selector.reach();
    for (std::size_t begin = 0; begin < cells.size(); begin += kBlock) {
      const std::size_t count = std::min<std::size_t>(kBlock, cells.size() - begin);
      fill(cells, begin, count);
      const Block& output = pass.forward();
      for (std::size_t i = 0; i < count; ++i) {
        const float value = output[i / kLanes][i % kLanes] - prior;  // [CN] eq. (3)
        log_odds[begin + i] = cells.range[begin + i] <= reach ? value : 0.0F;
      }
    }
  }

  mapping::SonarSelector selector;
  mapping::NetworkPass pass;
  float prior;

 private:
  void fill(const CellPlaces& cells, std::size_t begin, std::size_t count) {
    float range[kBlock] = {}, bearing[kBlock] = {};
    std::copy_n(cells.range.begin() + static_cast<std::ptrdiff_t>(begin), count, range);
    std::copy_n(cells.bearing.begin() + static_cast<std::ptrdiff_t>(begin), count, bearing);
    const std::span<Block> inputs = pass.inputs();
    for (std::size_t part = 0; part < kBlock / kLanes; ++part)
      selector.fill(selector.select(mapping::load(range + part * kLanes), mapping::load(bearing + part * kLanes)),
                    inputs, part);
  }
};

float wanted_of(CellTruth truth) {
  return truth == CellTruth::occupied ? 1.0F : truth == CellTruth::free ? 0.0F : 0.5F;
}

/// Calls body(first, after last) for each run of cells of one scan.
template <class Body>
void for_each_scan(const SonarLessons& lessons, const Body& body) {
  for (std::size_t begin = 0; begin < lessons.cells.size();) {
    std::size_t end = begin;
    while (end < lessons.cells.size() && lessons.cells[end].scan == lessons.cells[begin].scan) ++end;
    body(begin, end);
    begin = end;
  }
}

}  // namespace

void check_words(const std::string& what, const std::string& text) {
  std::string shown = visible_text(text);
  for (std::size_t at; (at = shown.find('\n')) != std::string::npos;) shown.replace(at, 1, "\\10");
  if (shown != text) fail("{}: one line without control characters expected, got '{}'", what, shown);
}

Examples examples_of(const SonarLessons& lessons, const SonarFeatures& features, const Work& work) {
  Examples examples;
  examples.inputs = features.inputs();
  if (lessons.cells.empty()) return examples;
  mapping::SonarSelector selector(lessons.ring, features);
  std::vector<Block> inputs(static_cast<std::size_t>(features.inputs()));
  const auto reach = static_cast<float>(features.reach);
  for_each_scan(lessons, [&](std::size_t begin, std::size_t end) {
    work.poll();
    selector.take({lessons.scan(lessons.cells[begin].scan), lessons.range_max});
    for (std::size_t i = begin; i < end; ++i) {
      const SonarLessons::Cell& cell = lessons.cells[i];
      if (cell.range > reach) continue;
      selector.fill(selector.select(mapping::all(cell.range), mapping::all(cell.bearing)), inputs, 0);
      for (const Block& input : inputs) examples.rows.push_back(input[0][0]);
      examples.wanted.push_back(wanted_of(cell.truth));
    }
  });
  return examples;
}

SonarNetwork train_sonar_network(const std::string& name, const SonarFeatures& features, const SonarLessons& lessons,
                                 const SonarLessons& validation, const TrainingOptions& options, const Work& work,
                                 const std::function<void(const TrainingEpoch&)>& on_epoch) {
  const Examples examples = examples_of(lessons, features, work);
  if (!validation.cells.empty()) check_ring("validation lessons", validation.ring, lessons.ring);
  SonarNetwork made{.name = name, .ring = lessons.ring, .features = features, .network = {}, .provenance = {}};
  made.network = train_network(examples, examples_of(validation, features, work), options, work, on_epoch);
  made.prior = learnt_prior(examples, options);
  return made;
}

NetworkScore model_score(const SonarModel& model, const SonarLessons& lessons, const Work& work) {
  check_ring("lessons", lessons.ring, model.ring);
  Examples examples;
  std::vector<float> log_odds, range, bearing;
  for (const SonarLessons::Cell& cell : lessons.cells) {
    range.push_back(cell.range);
    bearing.push_back(cell.bearing);
    examples.wanted.push_back(wanted_of(cell.truth));
  }
  log_odds.resize(range.size());
  for_each_scan(lessons, [&](std::size_t begin, std::size_t end) {
    work.poll();
    model.evaluate({lessons.scan(lessons.cells[begin].scan), lessons.range_max},
                   {std::span(range).subspan(begin, end - begin), std::span(bearing).subspan(begin, end - begin)},
                   std::span(log_odds).subspan(begin, end - begin));
  });
  return score_of(log_odds, examples);
}

SonarModel network_model(const SonarNetwork& network) {
  auto reader = std::make_shared<Reader>(network);
  return {.name = network.name,
          .ring = network.ring,
          .reach = network.features.reach,
          .evaluate = [reader](const SonarSweep& sweep, const CellPlaces& cells,
                               std::span<float> log_odds) { reader->evaluate(sweep, cells, log_odds); },
          .bytes = sizeof(Reader) + reader->pass.bytes()};
}

SonarNetwork shipped_network(const std::string& name, const std::string& preset, const RingLayout& ring) {
  sonar_features(name);
  const std::string path = fmt::format("models/{}_{}.txt", name, preset);
  const bool word = preset.find_first_of("/.") == std::string::npos;  // not the way to some other file
  const auto file = word ? find_file(path) : std::nullopt;
  if (!file) {
    std::vector<std::string> presets;
    for (const std::string& other : data_files("models/" + name + "_"))
      presets.push_back(other.substr(path.find('_') + 1, other.rfind('.') - path.find('_') - 1));
    fail("no weights of '{}' for the sonar '{}'; there are: {}{}", name, preset, listing(presets),
         did_you_mean(preset, presets));
  }
  SonarNetwork network = read_network(*file);
  check_ring(path, network.ring, ring);
  return network;
}

}  // namespace meander

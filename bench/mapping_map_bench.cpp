// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What one scan costs: into the local map, with each rule of fusion and each classic model, and into a global map of
// 1000 x 1000 cells. "nothing" is a local map whose model tells nothing: sliding, places and fusion alone.
#include <benchmark/benchmark.h>

#include "mapping/classic_models.hpp"
#include "mapping/sonar_map.hpp"

namespace meander {
namespace {

Observation scan_at(const Pose2& pose) {
  Observation seen;
  seen.odometry.pose = pose;
  for (int i = 0; i < 16; ++i) seen.readings.sonar.push_back(0.8 + 0.1 * (i % 7));
  seen.readings.sonar_pose.assign(16, pose);
  return seen;
}

SonarModel saying(float log_odds) {
  return {.name = "same",
          .ring = platform("nomad200").sonar,
          .reach = 10,
          .evaluate = [log_odds](const SonarSweep&, const CellPlaces& cells, std::span<float> out) {
            std::fill_n(out.begin(), cells.size(), log_odds);
          }};
}

std::vector<Observation> drive() {
  std::vector<Observation> scans;
  for (int i = 0; i < 64; ++i) scans.push_back(scan_at({0.03 * i, -0.02 * i, 0.1 * i}));
  return scans;
}

void step(benchmark::State& state, SonarModel model, Fusion rule) {
  LocalMapOptions options;
  options.fusion.rule = rule;
  LocalMap map(platform("nomad200"), std::move(model), options);
  const std::vector<Observation> scans = drive();
  std::size_t i = 0;
  for (auto _ : state) map.step(scans[i++ % scans.size()]);
}

/// With views, and everything that leaves the window kept.
void everywhere(benchmark::State& state) {
  SonarMap map(platform("nomad200"), saying(0.1F));
  const std::vector<Observation> scans = drive();
  std::size_t i = 0;
  for (auto _ : state) map.update(scans[i++ % scans.size()]);
}

void nothing(benchmark::State& state) { step(state, saying(0), Fusion::bayes); }
void bayes(benchmark::State& state) { step(state, saying(0.1F), Fusion::bayes); }
void viewbin(benchmark::State& state) { step(state, saying(0.1F), Fusion::viewbin); }
void elfes(benchmark::State& state) { step(state, cone_model(platform("nomad200").sonar), Fusion::viewbin); }
void ros(benchmark::State& state) { step(state, range_layer_model(platform("nomad200").sonar), Fusion::viewbin); }

/// The scan's window anywhere in a map that is there already.
void global_add(benchmark::State& state) {
  GlobalMap map(0.05, 4.6F);
  std::vector<float> increments(3600, 0.01F);
  for (int y = 0; y < 1000; y += 50)
    for (int x = 0; x < 1000; x += 50) map.add({x, y}, 60, increments);
  int k = 0;
  for (auto _ : state) {
    k = (k + 37) % 940;
    map.add({k, 940 - k}, 60, increments);
  }
}

BENCHMARK(nothing)->Unit(benchmark::kMicrosecond);
BENCHMARK(bayes)->Unit(benchmark::kMicrosecond);
BENCHMARK(viewbin)->Unit(benchmark::kMicrosecond);
BENCHMARK(elfes)->Unit(benchmark::kMicrosecond);
BENCHMARK(ros)->Unit(benchmark::kMicrosecond);
BENCHMARK(everywhere)->Unit(benchmark::kMicrosecond);
BENCHMARK(global_add)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

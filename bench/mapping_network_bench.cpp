// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// One scan of 60 x 60 cells by the networks, and their training. "cell_by_cell" is the named baseline: the same network
// with the library's tanh, one cell after the other; the counter "baseline/this" is the ratio to it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "base/random.hpp"
#include "mapping/cell_places.hpp"
#include "mapping/sonar_network.hpp"

namespace meander {
namespace {

const char* const kNames[] = {"nn1", "nn2", "nn3", "nn4", "nn5"};
const RingLayout kRing{16, 0.23, 0};
constexpr int kSide = 60;

SonarNetwork network_of(const char* name) {
  SonarNetwork made{.name = name, .ring = kRing, .features = sonar_features(name), .network = {}, .provenance = {}};
  made.network = random_network({made.features.inputs(), 16, 16, 1}, 1);
  return made;
}

struct Scan {
  std::vector<double> ranges = std::vector<double>(16);
  std::vector<float> range = std::vector<float>(kSide * kSide), bearing = range, log_odds = range;
  Stream random{1, "scan"};

  void next() {
    for (double& reading : ranges) reading = random.uniform(0.3, 4);
    cell_places({random.uniform(-1.5, -1.45), random.uniform(-1.5, -1.45)}, 0.05, kSide, kSide, random.uniform(-3, 3),
                range, bearing);
  }
};

template <class Body>
double run(benchmark::State& state, const Body& body) {
  const std::clock_t start = std::clock();
  for (auto _ : state) body();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(state.iterations());
}

double baseline = 0;

void cell_by_cell(benchmark::State& state) {
  const SonarNetwork made = network_of("nn4");
  const SonarLessons::Cell cell{};
  SonarLessons lessons{.ring = kRing, .range_max = 6.477, .ranges = std::vector<double>(16, 1.0), .cells = {}};
  lessons.cells.assign(kSide * kSide, cell);
  const Examples examples = examples_of(lessons, made.features);
  baseline = run(state, [&] {
    float sum = 0;
    for (std::size_t i = 0; i < examples.size(); ++i) {
      const float* w = made.network.weights.data();
      float values[2][16];
      std::copy_n(examples.row(i).begin(), 5, values[0]);
      int inputs = 5;
      for (int layer = 0; layer < 2; ++layer, inputs = 16)
        for (int unit = 0; unit < 16; ++unit, ++w) {
          float s = 0;
          for (int k = 0; k < inputs; ++k) s += *w++ * values[layer % 2][k];
          values[(layer + 1) % 2][unit] = std::tanh(s + *w);
        }
      for (int k = 0; k < 16; ++k) sum += w[k] * values[0][k];
    }
    benchmark::DoNotOptimize(sum);
  });
}

void places(benchmark::State& state) {
  Scan scan;
  run(state, [&] {
    scan.next();
    benchmark::DoNotOptimize(scan.range.data());
  });
}

void scan_by(benchmark::State& state, const SonarModel& model) {
  Scan scan;
  scan.next();
  const double seconds = run(state, [&] {
    model.evaluate({scan.ranges, 6.477}, {scan.range, scan.bearing}, scan.log_odds);
    benchmark::DoNotOptimize(scan.log_odds.data());
  });
  if (baseline > 0) state.counters["baseline/this"] = baseline / seconds;
  state.SetLabel(model.name);
}
void exact(benchmark::State& state) { scan_by(state, network_model(network_of(kNames[state.range(0)]))); }
void table(benchmark::State& state) { scan_by(state, table_model(network_of(kNames[state.range(0)]))); }
void compile(benchmark::State& state) {
  const SonarNetwork network = network_of(kNames[state.range(0)]);
  run(state, [&] { benchmark::DoNotOptimize(table_model(network).reach); });
}

/// As many examples as the default of examples/train_sonar_model.lua gives.
void training(benchmark::State& state) {
  Stream random(1, "examples");
  Examples examples{.inputs = 5, .rows = {}, .wanted = {}};
  for (int i = 0; i < 126500; ++i) {
    float sum = 0;
    for (int k = 0; k < 5; ++k) {
      examples.rows.push_back(static_cast<float>(random.uniform(-1, 1)));
      sum += examples.rows.back();
    }
    examples.wanted.push_back(sum > 0.5F ? 1.0F : 0.0F);
  }
  run(state, [&] { benchmark::DoNotOptimize(train_network(examples, {}, {}).weights.data()); });
}

BENCHMARK(cell_by_cell)->Unit(benchmark::kMicrosecond);
BENCHMARK(places)->Unit(benchmark::kMicrosecond);
BENCHMARK(exact)->DenseRange(0, 4)->Unit(benchmark::kMicrosecond);
BENCHMARK(table)->DenseRange(0, 4)->Unit(benchmark::kMicrosecond);
BENCHMARK(compile)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(training)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// One equilibrium of the polar map, and its parts. "gauss_seidel" is the named baseline: plain sweeps over the units,
// sector after sector, 40 times there and back; the counter "plain/this" is the ratio to it.
#include <benchmark/benchmark.h>

#include <ctime>
#include <map>

#include "../tests/unit/polar_support.hpp"
#include "polar/polar_lines.hpp"
#include "polar/polar_navigator.hpp"

namespace meander {
namespace {

constexpr double kKappa = 30;

struct Setup {
  PolarLayout layout;
  std::vector<RingWeights> weights;
  std::vector<std::vector<Vec2>> points;
  std::vector<Projection> maps;
  double plain_seconds = 0;
};

Setup& setup(const benchmark::State& state) {
  static std::map<std::pair<std::int64_t, std::int64_t>, Setup> cache;
  const auto key = std::pair(state.range(0), state.range(1));
  if (const auto it = cache.find(key); it != cache.end()) return it->second;
  PolarLayoutOptions options{.rings = static_cast<int>(key.first), .sectors = static_cast<int>(key.second)};
  if (options.rings <= 32) options.radii = PolarRadii::log;
  const PolarLayout layout(options);
  Setup made{layout, ring_weights(layout, PolarWeights::finite_volume, kKappa), {}, {}, 0};
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    made.points.push_back(random_points(seed));
    made.maps.push_back(projected(layout, made.points.back()));
  }
  return cache.emplace(key, std::move(made)).first->second;
}

template <class Body>
double run(benchmark::State& state, const Body& body) {
  std::size_t k = 0;
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    body(k);
    k = (k + 1) % 50;
  }
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(state.iterations());
}

void gauss_seidel(benchmark::State& state) {
  Setup& here = setup(state);
  const int n = here.layout.rings(), m = here.layout.sectors();
  std::vector<double> v;
  here.plain_seconds = run(state, [&](std::size_t k) {
    v.assign(static_cast<std::size_t>((n + 2) * m), 0.0);
    const auto at = [&](int r, int s) -> double& {
      return v[static_cast<std::size_t>(here.layout.wrapped(s) * (n + 2) + r + 1)];
    };
    at(n - 1, 0) = 1;
    const auto update = [&](int r, int s) {
      if ((s == 0 && r == n - 1) || here.maps[k].layer(0).test(r, s)) return;
      const RingWeights& w = here.weights[static_cast<std::size_t>(r)];
      at(r, s) =
          (w.inward * at(r - 1, s) + w.outward * at(r + 1, s) + w.lateral * (at(r, s - 1) + at(r, s + 1))) / w.total;
    };
    for (int sweep = 0; sweep < 40; ++sweep) {
      for (int s = 0; s < m; ++s)
        for (int r = n - 1; r >= 0; --r) update(r, s);
      for (int s = m - 1; s >= 0; --s)
        for (int r = 0; r < n; ++r) update(r, s);
    }
    benchmark::DoNotOptimize(v.data());
  });
}

void solver_with(benchmark::State& state, const polar::LineKernels& kernels) {
  Setup& here = setup(state);
  PolarSolver solver(here.layout, here.weights, &kernels);
  const double seconds = run(state, [&](std::size_t k) {
    solver.solve(here.maps[k].layer(0), here.layout.rings() - 1);
    benchmark::DoNotOptimize(solver.activation(0, 0));
  });
  if (here.plain_seconds > 0) state.counters["plain/this"] = here.plain_seconds / seconds;
}

void solver(benchmark::State& state) { solver_with(state, polar::line_kernels().back()); }
void solver_portable(benchmark::State& state) { solver_with(state, polar::line_kernels().front()); }

void projection(benchmark::State& state) {
  Setup& here = setup(state);
  Projection map(here.layout, {0.3167, 0.3367, 0.5667});
  for (const std::size_t layer : {std::size_t{1}, std::size_t{2}}) map.set_reach(layer, 0.5);
  run(state, [&](std::size_t k) {
    map.clear();
    for (const Vec2& point : here.points[k]) map.add(point);
    benchmark::DoNotOptimize(map.layer(0).test(1, 0));
  });
}

/// A whole control cycle, driving past what the sonars report.
void cycle(benchmark::State& state) {
  Setup& here = setup(state);
  PolarOptions options;
  options.map.layout = {.rings = here.layout.rings(), .sectors = here.layout.sectors()};
  if (options.map.layout.rings <= 32) options.map.layout.radii = PolarRadii::log;
  PolarNavigator navigator(platform("nomad200"), options);
  Observation observation;
  observation.period = 0.33;
  observation.readings.sonar.resize(16);
  observation.readings.sonar_pose.resize(16);
  Stream random(1, "readings");
  run(state, [&](std::size_t k) {
    observation.time += 0.33;
    observation.odometry = {{0.1 * static_cast<double>(k), 0, 0}, 0.3, 0};
    for (std::size_t i = 0; i < 16; ++i) {
      observation.readings.sonar[i] = random.uniform(0.6, 3.2);
      observation.readings.sonar_pose[i] = observation.odometry.pose;
    }
    benchmark::DoNotOptimize(
        navigator.step(observation, {.position = {100, 1}, .tolerance = 0.25, .heading = {}, .name = {}}));
  });
  state.counters["points"] = static_cast<double>(navigator.points().size());
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"rings", "sectors"})->Unit(benchmark::kMicrosecond);
  b->Args({100, 48})->Args({100, 32})->Args({32, 32});
}
BENCHMARK(gauss_seidel)->Apply(sizes);
BENCHMARK(solver)->Apply(sizes);
BENCHMARK(solver_portable)->Apply(sizes);
BENCHMARK(projection)->Apply(sizes);
BENCHMARK(cycle)->Apply(sizes);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

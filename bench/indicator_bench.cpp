// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// A route over so many indicators, between random pairs. "dijkstra" is the named baseline; the counter "dijkstra/this"
// is the ratio to it in the same run.
#include <benchmark/benchmark.h>

#include <ctime>
#include <map>

#include "base/random.hpp"
#include "indicator/dijkstra.hpp"
#include "indicator/path_network.hpp"

namespace meander {
namespace {

struct Setup {
  RouteLinks links;
  std::vector<std::pair<int, int>> pairs;
  double dijkstra_seconds = 0;
};

/// Crossings of a square labyrinth: a random spanning tree and a fifth of the other links.
RouteLinks labyrinth(int side, Stream& random) {
  const int n = side * side;
  std::vector<int> root(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) root[static_cast<std::size_t>(i)] = i;
  const auto find = [&](int i) {
    while (root[static_cast<std::size_t>(i)] != i) i = root[static_cast<std::size_t>(i)];
    return i;
  };
  std::vector<RouteLinks::Edge> all, edges;
  for (int i = 0; i < n; ++i) {
    if (i % side + 1 < side) all.push_back({i, i + 1, random.uniform(1, 4)});
    if (i + side < n) all.push_back({i, i + side, random.uniform(1, 4)});
  }
  for (std::size_t i = all.size(); i > 1; --i)
    std::swap(all[i - 1], all[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  for (const RouteLinks::Edge& edge : all) {
    const int a = find(edge.a), b = find(edge.b);
    if (a == b && !random.chance(0.2)) continue;
    root[static_cast<std::size_t>(a)] = b;
    edges.push_back(edge);
  }
  return {n, edges};
}

Setup& setup(const benchmark::State& state) {
  static std::map<std::int64_t, Setup> cache;
  const auto side = state.range(0);
  if (const auto it = cache.find(side); it != cache.end()) return it->second;
  Stream random(1, "bench");
  Setup made{labyrinth(static_cast<int>(side), random), {}, 0};
  for (int i = 0; i < 41; ++i)
    made.pairs.emplace_back(random.below(made.links.size()), random.below(made.links.size()));
  return cache.emplace(side, std::move(made)).first->second;
}

template <class Body>
double run(benchmark::State& state, const Setup& here, const Body& body) {
  std::size_t k = 0;
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    body(here.pairs[k].first, here.pairs[k].second);
    k = (k + 1) % here.pairs.size();
  }
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(state.iterations());
}

void dijkstra(benchmark::State& state) {
  Setup& here = setup(state);
  here.dijkstra_seconds =
      run(state, here, [&](int start, int goal) { benchmark::DoNotOptimize(dijkstra_path(here.links, start, goal)); });
}

void network(benchmark::State& state) {
  Setup& here = setup(state);
  PathNetwork network;
  double rows = 0;
  const double seconds = run(state, here, [&](int start, int goal) {
    network.excite(here.links, start, goal, NetworkRows::adaptive);
    benchmark::DoNotOptimize(network.decrypt(*network.selected()));
    rows = std::max(rows, static_cast<double>(network.rows()));
  });
  state.counters["rows"] = rows;
  if (here.dijkstra_seconds > 0) state.counters["dijkstra/this"] = here.dijkstra_seconds / seconds;
}

/// The waves of a decision have no goal: everything that can be reached gets its distance.
void wave(benchmark::State& state) {
  Setup& here = setup(state);
  PathNetwork network;
  run(state, here, [&](int start, int) {
    network.excite(here.links, start, std::nullopt, NetworkRows::adaptive);
    benchmark::DoNotOptimize(network.potentials().data());
  });
}

void sides(benchmark::internal::Benchmark* b) { b->ArgName("side")->Unit(benchmark::kMicrosecond)->Arg(40)->Arg(100); }
BENCHMARK(dijkstra)->Apply(sides);
BENCHMARK(network)->Apply(sides);
BENCHMARK(wave)->Apply(sides);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What an edit costs must not grow with the world: time per item at 20,000 obstacles against that at 1,000.
#include <benchmark/benchmark.h>

#include "world/world_file.hpp"

namespace {

using namespace meander;

Obstacle box(int i) { return {"", Rectangle{{i % 141 * 1.4, i / 141 * 1.35}, {0.2, 0.2}, 0}, {}}; }

World full(int count) {
  World world(Header{"big", "", {{0, 0}, {200, 200}}, Pose2{199, 199, 0}});
  for (int i = 0; i < 13; ++i) world.add(Place{"", {198, 199.0 - i}, {}, 0.25});
  for (int i = 0; i < count; ++i) world.add(box(i));
  return world;
}

void per_item(benchmark::State& state) {
  state.counters["per_item"] = benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)),
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void add(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(full(static_cast<int>(state.range(0))));
  per_item(state);
}
BENCHMARK(add)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);

void undo_and_redo(benchmark::State& state) {
  World world = full(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    world.undo(static_cast<int>(state.range(0)));
    world.redo(static_cast<int>(state.range(0)));
  }
  per_item(state);
}
BENCHMARK(undo_and_redo)->Arg(1000)->Arg(20000)->Iterations(5)->Unit(benchmark::kMillisecond);

void fork(benchmark::State& state) {
  const World world = full(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    World copy = world;
    benchmark::DoNotOptimize(copy);
  }
  per_item(state);
}
BENCHMARK(fork)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);

void write_and_read(benchmark::State& state) {
  const World world = full(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(world_from_toml(to_toml(world)));
  per_item(state);
}
BENCHMARK(write_and_read)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

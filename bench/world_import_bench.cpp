// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Import of large rasters. Baseline: one look at every cell (a copy of the raster), so the ratio says how many such
// looks tracing costs.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "base/random.hpp"
#include "grid/image_file.hpp"
#include "world/import_floor_plan.hpp"

namespace meander {
namespace {

/// Rooms of 40 x 40 cells with ragged walls and doors, and clutter in them.
Grid<std::uint8_t> rooms(int side) {
  Stream stream(1, "rooms");
  Grid<std::uint8_t> grid(side, side, 0, {0.05, {}});
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const bool wall = (x % 40 < 3 && y % 40 > 10) || (y % 40 < 3 && x % 40 > 10);
      grid[{x, y}] = (wall && !stream.chance(0.02)) || stream.chance(0.002);
    }
  return grid;
}

void copy(benchmark::State& state) {
  const auto grid = rooms(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    auto copied = grid.cells();
    benchmark::DoNotOptimize(copied.data());
  }
}

void trace_rooms(benchmark::State& state) {
  const auto grid = rooms(static_cast<int>(state.range(0)));
  std::size_t edges = 0;
  for (auto _ : state) edges = trace(grid).edges;
  state.counters["edges"] = static_cast<double>(edges);
}

/// All of it: file, threshold, outlines, checked world.
void import_rooms(benchmark::State& state) {
  const auto grid = rooms(static_cast<int>(state.range(0)));
  Image image{grid.width(), grid.height(), 1, {}};
  for (const auto cell : grid.cells()) image.pixels.push_back(cell ? 0 : 255);
  const std::string path = (std::filesystem::temp_directory_path() / "meander_import_bench.png").string();
  write_image(path, image);
  for (auto _ : state) benchmark::DoNotOptimize(import_floor_plan(path).world.size());
  std::filesystem::remove(path);
}

BENCHMARK(copy)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(trace_rooms)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(import_rooms)->Arg(2000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

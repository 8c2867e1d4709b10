// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Neural maps solved to 1e-6 in every unit. "dijkstra" is the named baseline in the same run: the distance transform of
// the same map, 8-connected, with buckets. Times per reachable cell, set-up and landscape included.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include "../tests/unit/planning_neural_maps.hpp"
#include "planning/distance_transform.hpp"
#include "planning/harmonic.hpp"
#include "planning/neural_map.hpp"
#include "planning/neural_replanner.hpp"
#include "planning/neural_tiles.hpp"

namespace meander {
namespace {

using namespace neural_maps;

PlanningProblem problem(int kind, int size) {
  PlanningProblem made{.blocked = {}, .targets = {{1, 1}}};
  switch (kind) {
    case 0:
      made.blocked = open_floor(size, size);
      break;
    case 1:
      made.blocked = clutter(size, size, 0.2, 7);
      break;
    case 2:
      made.blocked = rooms(size, size, 25, 7);
      break;
    case 3:
      made.blocked = perfect_maze(size | 1, size | 1, 7);
      break;
    case 4:
      made.blocked = serpentine(size, size, 5);
      break;
    default:
      made.blocked = open_floor(2 * size, size);
  }
  made.blocked[{1, 1}] = 0;
  return made;
}
constexpr const char* kKinds[] = {"open", "clutter", "rooms", "maze", "serpentine", "open 2:1"};

/// Least processor time of three runs [s].
template <class F>
double best_of_three(F run) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const std::clock_t before = std::clock();
    run();
    best = std::min(best, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  return best;
}

/// Arguments: kind, size, kernel (index of tile_kernels(), or -1: what solve_tiles chooses).
void solve(benchmark::State& state) {
  const PlanningProblem p = problem(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const auto number = static_cast<std::size_t>(state.range(2));
  const TileKernel* kernel = nullptr;
  if (state.range(2) >= 0) {
    if (number >= tile_kernels().size()) return state.SkipWithError("not on this processor");
    kernel = tile_kernels()[number];
  }
  const double dijkstra = best_of_three([&] { benchmark::DoNotOptimize(distance_transform(p)); });
  PlanningResult result;
  double least = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    const std::clock_t before = std::clock();
    result = solve_tiles(p, {}, {}, kernel);
    least = std::min(least, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  const auto cells = static_cast<double>(result.statistics.cells);
  state.SetLabel(std::string(kKinds[state.range(0)]) + (kernel != nullptr ? std::string(" ") + kernel->name : ""));
  state.counters["ns_per_cell"] = 1e9 * least / cells;
  state.counters["dijkstra_ns"] = 1e9 * dijkstra / cells;
  state.counters["x_dijkstra"] = least / dijkstra;
  state.counters["updates"] = static_cast<double>(result.statistics.relaxations) / cells;
  state.counters["residual"] = result.statistics.residual;
}
BENCHMARK(solve)
    ->ArgsProduct({{0, 1, 2, 3, 4}, {200, 1000}, {-1}})
    ->Args({5, 500, -1})
    ->ArgsProduct({{0, 1, 2}, {1000}, {1, 2, 3}})
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

/// Harmonic functions, exactly, and how many times as long as the neural map they take. Arguments: kind, size.
void harmonic_exact(benchmark::State& state) {
  const PlanningProblem p = problem(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const double neural = best_of_three([&] { benchmark::DoNotOptimize(solve_tiles(p, {})); });
  const double exact = best_of_three([&] { benchmark::DoNotOptimize(meander::harmonic(p)); });
  for (auto _ : state) benchmark::DoNotOptimize(p);
  state.SetLabel(kKinds[state.range(0)]);
  state.counters["exact_ms"] = 1000 * exact;
  state.counters["neural_ms"] = 1000 * neural;
  state.counters["x_neural"] = exact / neural;
}
BENCHMARK(harmonic_exact)->ArgsProduct({{0, 1, 2, 3}, {50, 200, 500}})->Iterations(1);

/// Updates per cell of every solver, 200 x 200.
void solvers(benchmark::State& state) {
  const PlanningProblem p = problem(static_cast<int>(state.range(0)), 200);
  const auto solver = static_cast<NeuralSolver>(state.range(1));
  PlanningResult result;
  for (auto _ : state) result = neural_map(p, {.solver = solver});
  state.SetLabel(std::string(kKinds[state.range(0)]) + " " + to_string(solver));
  state.counters["updates"] =
      static_cast<double>(result.statistics.relaxations) / static_cast<double>(result.statistics.cells);
}
BENCHMARK(solvers)->ArgsProduct({{0, 1, 2, 3}, {1, 2}})->Iterations(1)->Unit(benchmark::kMillisecond);

/// Cells that can be reached and have no neighbour of more activation, counted from the landscape; and how many can.
void dead_units(benchmark::State& state) {
  const PlanningProblem p = problem(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  PlanningResult result;
  for (auto _ : state) result = solve_tiles(p, {});
  const Grid<std::uint8_t> reachable = reachable_cells(p);
  double dead = 0, lowest = 0;
  for (int y = 0; y < reachable.height(); ++y)
    for (int x = 0; x < reachable.width(); ++x) {
      if (reachable[{x, y}] == 0 || result.value[{x, y}] == 0) continue;
      bool higher = false;
      for (const LatticeStep& step : lattice_steps(p.lattice))
        higher = higher || (open_step(p.blocked, p.corners, {x, y}, step) &&
                            result.value[{x + step.dx, y + step.dy}] > result.value[{x, y}]);
      if (!higher) ++dead;
      lowest = std::min(lowest, result.value[{x, y}]);
    }
  state.SetLabel(kKinds[state.range(0)]);
  state.counters["dead"] = dead;
  state.counters["cells"] = static_cast<double>(result.statistics.cells);
  state.counters["lowest_ln_v"] = lowest;
  state.counters["residual"] = result.statistics.residual;
}
BENCHMARK(dead_units)
    ->Args({5, 500})
    ->Args({3, 2001})
    ->Args({4, 1000})
    ->Args({2, 4096})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// Wall time of one and two threads, and how many processors were at work: 1 to 2.
void threads(benchmark::State& state) {
  const PlanningProblem p = problem(2, static_cast<int>(state.range(0)));
  const std::clock_t before = std::clock();
  const auto start = std::chrono::steady_clock::now();
  for (auto _ : state) benchmark::DoNotOptimize(solve_tiles(p, {.threads = static_cast<int>(state.range(1))}));
  const double busy = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  state.counters["processors"] = busy / std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
BENCHMARK(threads)->ArgsProduct({{1000, 4096}, {1, 2}})->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

/// A block of 5 x 5 cells put somewhere or taken away, walls included, or two cells of a wall opened or closed.
std::vector<CellEdit> random_edit(Stream& random) {
  const bool door = random.chance(0.4), across = random.chance(0.5), blocked = random.chance(0.5);
  const int along = random.below(490) + 4;
  const int wall = door ? 25 * random.below(19) + 24 : random.below(490) + 4;
  const Cell corner = across ? Cell{along, wall} : Cell{wall, along};
  const int width = !door ? 5 : across ? 2 : 1, height = !door ? 5 : across ? 1 : 2;
  std::vector<CellEdit> edits;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) edits.push_back({{corner.x + x, corner.y + y}, blocked});
  return edits;
}

/// Largest difference between what two landscapes say about the way from a cell to a neighbour; and counts the cells
/// that only one of them reaches.
double worst_difference(const PlanningProblem& p, const Grid<double>& a, const Grid<double>& b, double& unlike) {
  double worst = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if ((a[{x, y}] == kNoValue) != (b[{x, y}] == kNoValue)) ++unlike;
      if (a[{x, y}] == kNoValue) continue;
      for (const LatticeStep& step : lattice_steps(p.lattice))
        if (const Cell next{x + step.dx, y + step.dy}; open_step(p.blocked, p.corners, {x, y}, step))
          worst = std::max(worst, std::abs((a[next] - a[{x, y}]) - (b[next] - b[{x, y}])));
    }
  return worst;
}

/// Random edits of rooms, 500 x 500. After each the landscape against one from scratch, and what both cost.
void edits_exact(benchmark::State& state) {
  NeuralReplanner replanner(problem(2, 500));
  Stream random(2501, "edits");
  double worst = 0, unlike = 0, follow = 0, scratch = 0, dearest = 0;
  const auto seconds_of = [](auto run) {
    const std::clock_t before = std::clock();
    run();
    return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  };
  for (auto _ : state) {
    const std::vector<CellEdit> edit = random_edit(random);
    const double one = seconds_of([&] { replanner.edit(edit); });
    PlanningResult fresh;
    scratch += seconds_of([&] { fresh = solve_tiles(replanner.problem(), {}); });
    follow += one;
    dearest = std::max(dearest, one);
    worst = std::max(worst, worst_difference(replanner.problem(), replanner.landscape().value, fresh.value, unlike));
  }
  const double count = static_cast<double>(state.iterations());
  state.counters["worst"] = worst;
  state.counters["unlike"] = unlike;
  state.counters["edit_ms"] = 1000 * follow / count;
  state.counters["dearest_ms"] = 1000 * dearest;
  state.counters["scratch_ms"] = 1000 * scratch / count;
  state.counters["share"] = follow / scratch;
}
BENCHMARK(edits_exact)->Iterations(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

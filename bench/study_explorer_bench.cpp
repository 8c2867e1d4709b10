// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What the explorer by sonar takes of a control cycle, in three runs each through labyrinths of so many cells a side.
// Counters: medians of the processor time of cycles in which it decides and in which it does not, the mean of all [us],
// their numbers, and "baseline/decision": one flood of all that is free on the final map against the median of a cycle
// with a decision.
#include <benchmark/benchmark.h>

#include <time.h>

#include <algorithm>
#include <numeric>

#include "autonomy/sonar_explorer.hpp"
#include "polar/polar_navigator.hpp"
#include "study/drive.hpp"
#include "world/generate_labyrinth.hpp"

namespace meander {
namespace {

double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> of) {
  if (of.empty()) return 0;
  const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
  std::nth_element(of.begin(), middle, of.end());
  return *middle;
}

Platform small_robot() {
  Platform robot = platform("nomad200");
  robot.body.radius = robot.bumper.radius = 0.2;
  robot.sonar.radius = 0.17;
  return robot;
}

RobotOptions with_sonars() {
  RobotOptions robot;
  robot.platform = small_robot();
  robot.sonar = sonar_preset("nomad");
  robot.sonar.incidence = false;
  robot.sonar.corner_range = 0;
  robot.sonar.firing = Firing::simultaneous;
  robot.drift = drift_preset("none");
  return robot;
}

/// Processor times of the cycles [us].
struct Times {
  std::vector<double> deciding, driving;
};

/// The explorer's guide, with a clock.
Guide timed(const std::shared_ptr<SonarExplorer>& explorer, Times& times) {
  Guide guide = exploring_guide(explorer);
  guide.next = [&times, explorer, next = guide.next](const Observation& observation, const NavigatorStep& step) {
    const auto decisions = explorer->explorer().state().decisions;
    const double start = now();
    GuideStep said = next(observation, step);
    const double took = now() - start;
    (explorer->explorer().state().decisions > decisions ? times.deciding : times.driving).push_back(took);
    return said;
  };
  return guide;
}

void explorer_by_sonar(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  Times times;
  double flood = 0;
  std::vector<double> runs;
  for (auto _ : state)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Labyrinth cells = make_labyrinth({.seed = seed, .columns = side, .rows = side, .loops = 0.1});
      const Vec2 goal(side - 0.5, side - 0.5);
      const auto explorer = std::make_shared<SonarExplorer>(goal, small_robot());
      for (std::uint64_t run = 1; run <= 3; ++run) {
        const auto world = std::make_shared<World>(labyrinth_world(cells, {}, seed));
        SimOptions options;
        options.seed = 10 * seed + run;
        Sim sim(world, {with_sonars()}, options);
        drive(sim, polar_navigator(small_robot(), {}), timed(explorer, times), {.time_limit = 3000, .record_every = 0});
        if (explorer->ending() != Ending::reached) state.SkipWithError(explorer->reason().c_str());
      }
      GeodesicField field;
      const double start = now();
      field.spread(explorer->map().space(), explorer->map().space().frame().cell(goal), 1e9);
      flood += (now() - start) / 3;
    }
  const auto sum = [](const std::vector<double>& of) { return std::accumulate(of.begin(), of.end(), 0.0); };
  const auto count = static_cast<double>(times.deciding.size() + times.driving.size());
  state.counters["decision"] = median(times.deciding);
  state.counters["cycle"] = median(times.driving);
  state.counters["mean"] = (sum(times.deciding) + sum(times.driving)) / count;
  state.counters["decisions"] = static_cast<double>(times.deciding.size());
  state.counters["cycles"] = count;
  state.counters["baseline/decision"] = flood / median(times.deciding);
}

BENCHMARK(explorer_by_sonar)->ArgName("side")->Arg(6)->Arg(10)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

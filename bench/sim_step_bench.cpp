// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// A whole step: kinematics, contact, movers, drift, scan, bumpers. Each line reports CPU microseconds per step,
// simulated seconds per CPU second, and the time as a ratio to the baseline of the same run: the same robot and scan in
// an empty room.
#include <benchmark/benchmark.h>

#include <time.h>

#include <cmath>

#include "sim/sim.hpp"

namespace meander {
namespace {

/// Rooms of 5 x 4 m with doors of 0.9 m and some furniture, as many as give about this number of segments.
std::shared_ptr<World> rooms(int segments) {
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(segments / 26.0))));
  Header header;
  header.bounds = {{0, 0}, {5.0 * side, 4.0 * side}};
  auto world = std::make_shared<World>(header);
  Stream random(1, "rooms");
  const auto wall = [&](const Vec2& a, const Vec2& b) {
    world->add(Obstacle{.name = "", .shape = Chain{{a, b}, false}, .surface = {}});
  };
  for (int i = 0; i <= side; ++i)
    for (int k = 0; k < side; ++k) {
      const double door = i % side == 0 ? 0 : 0.45, x = 5.0 * i, y = 4.0 * i;
      wall({x, 4.0 * k}, {x, 4.0 * k + 2 - door});
      wall({x, 4.0 * k + 2 + door}, {x, 4.0 * k + 4});
      wall({5.0 * k, y}, {5.0 * k + 2.5 - door, y});
      wall({5.0 * k + 2.5 + door, y}, {5.0 * k + 5, y});
    }
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k)
      for (const Vec2& corner : {Vec2{0.8, 0.7}, Vec2{4.2, 0.7}, Vec2{0.8, 3.3}, Vec2{4.2, 3.3}}) {
        const Vec2 at = Vec2{5.0 * i, 4.0 * k} + corner + Vec2{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
        world->add(Obstacle{.name = "", .shape = Rectangle{at, {0.6, 0.5}, random.uniform(-3, 3)}, .surface = {}});
      }
  return world;
}

RobotOptions nomad(const Pose2& start, const std::string& sonar) {
  RobotOptions robot;
  robot.platform = platform("nomad200");
  robot.sonar = sonar_preset(sonar);
  robot.drift = drift_preset("good");
  robot.start = start;
  return robot;
}

/// Drives about and, where a sonar sees something near ahead, turns away from it.
Command wander(const Observation& seen) {
  double nearest = 10, left = 0, right = 0;
  const auto& sonar = seen.readings.sonar;
  for (const int i : {14, 15, 0, 1, 2}) nearest = std::min(nearest, sonar[static_cast<std::size_t>(i)]);
  for (const std::size_t i : {1u, 2u, 3u}) left += sonar[i], right += sonar[16 - i];
  return nearest > 0.5 ? Command{0.5, 0.1, 0} : Command{0.05, left > right ? 0.7 : -0.7, 0};
}

/// CPU seconds of this process: the machine may be busy with other things.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Of the empty room, which runs first.
double baseline = 0;

void run(benchmark::State& state, Sim sim, bool is_baseline = false) {
  for (int i = 0; i < 200; ++i) sim.step(wander(sim.observation()));
  const double begin = cpu_seconds();
  for (auto _ : state) benchmark::DoNotOptimize(sim.step(wander(sim.observation())).time);
  const double seconds = (cpu_seconds() - begin) / static_cast<double>(state.iterations());
  if (is_baseline) baseline = seconds;
  state.counters["us_per_step"] = 1e6 * seconds;
  state.counters["simulated_s_per_cpu_s"] = sim.period() / seconds;
  state.counters["ratio_to_empty_room"] = seconds / baseline;
}

SimOptions ten_hertz() {
  SimOptions options;
  options.period = 0.1;
  return options;
}

void empty_room(benchmark::State& state) {
  run(state, Sim(rooms(26), {nomad({2.5, 2, 0}, "nomad")}, ten_hertz()), true);
}

void in_rooms(benchmark::State& state, const std::string& sonar) {
  auto world = rooms(static_cast<int>(state.range(0)));
  const Vec2 middle = world->header().bounds.center();
  const Vec2 start{5 * std::floor(middle.x() / 5) + 2.5, 4 * std::floor(middle.y() / 4) + 2};
  run(state, Sim(world, {nomad({start.x(), start.y(), 0}, sonar)}, ten_hertz()));
}

void with_walkers(benchmark::State& state) {
  auto world = rooms(300);
  for (int i = 0; i < 6; ++i)
    world->add(Mover{.name = "",
                     .disc = {{2.5 + 5 * (i % 3), 2.0 + 4 * (1 + i / 3)}, 0.25},
                     .motion = Motion::random_walk,
                     .waypoints = {},
                     .speed = 0.5,
                     .yields = true});
  run(state, Sim(world, {nomad({2.5, 2, 0}, "nomad")}, ten_hertz()));
}

BENCHMARK(empty_room);
BENCHMARK_CAPTURE(in_rooms, ideal, std::string("ideal"))->Arg(300);
BENCHMARK_CAPTURE(in_rooms, nomad, std::string("nomad"))->Arg(300)->Arg(3000)->Arg(20000);
BENCHMARK_CAPTURE(in_rooms, real, std::string("real"))->Arg(300)->Arg(20000);
BENCHMARK(with_walkers);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Scans of a ring of 16 sonars on a wandering robot, effect by effect. "brute" is the named baseline: a bundle of nine
// rays per sonar, each met with every wall and without any effect; the counter "brute/this" is the ratio to it.
#include <benchmark/benchmark.h>

#include <ctime>
#include <map>

#include "base/random.hpp"
#include "sensor/sonar.hpp"

namespace meander {
namespace {

constexpr int kCount = 16, kRaysPerCone = 9;
constexpr double kStep = 0.06;  // metres between scans: 0.6 m/s at 10 Hz

void add(World& world, Shape shape) { world.add(Obstacle{.name = {}, .shape = std::move(shape), .surface = {}}); }

/// Rotated boxes, 0.75 walls per square metre.
double fill_hall(World& world, int walls, Stream& random) {
  const double side = std::sqrt(walls / 0.75);
  add(world, Chain{{{0, 0}, {side, 0}, {side, side}, {0, side}}, true});
  for (int i = 0; i < walls / 4; ++i)
    add(world, Rectangle{{random.uniform(0, side), random.uniform(0, side)},
                         {random.uniform(0.3, 1.5), random.uniform(0.3, 1.5)},
                         random.uniform(0, kPi)});
  return side;
}

/// Rooms of 5 x 4 m with doors of 0.9 m and furniture, 1.6 walls per square metre.
double fill_rooms(World& world, int walls, Stream& random) {
  const int side = std::max(3, static_cast<int>(std::sqrt(walls / 32.0)));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Vec2 corner(5.0 * x, 4.0 * y);
      const double door = random.uniform(0.5, 2.5), gate = random.uniform(0.5, 2.5);
      add(world, Chain{{corner + Vec2(0, gate), corner, corner + Vec2(door, 0)}, false});
      add(world, Chain{{corner + Vec2(0, gate + 0.9), corner + Vec2(0, 4)}, false});
      add(world, Chain{{corner + Vec2(door + 0.9, 0), corner + Vec2(5, 0)}, false});
      for (int box = 0; box < 7; ++box)
        add(world, Rectangle{corner + Vec2(random.uniform(0.3, 4.7), random.uniform(0.3, 3.7)),
                             {random.uniform(0.2, 0.9), random.uniform(0.2, 0.9)},
                             random.uniform(0, kPi)});
    }
  return 4.0 * side;
}

struct Place {
  Scene scene;
  std::vector<Wall> walls;
  std::vector<Pose2> path;
  double brute_seconds = 0;
};

/// Straight on where there is room, else turning.
std::vector<Pose2> wander(const ShapeIndex& index, double side, int steps, Stream& random) {
  Pose2 pose{side / 2, side / 2, 0};
  while (index.inside(pose.position()) || index.distance(pose.position(), 1) < 0.4) {
    pose.x = random.uniform(0.3, 0.7) * side;
    pose.y = random.uniform(0.3, 0.7) * side;
  }
  std::vector<Pose2> path;
  while (static_cast<int>(path.size()) < steps) {
    Pose2 next = pose;
    next.heading = wrap_angle(pose.heading + random.uniform(-0.1, 0.1));
    const Vec2 p = pose.position() + kStep * next.direction();
    next.x = p.x(), next.y = p.y();
    if (index.distance(p, 1) < 0.35) {
      pose.heading = wrap_angle(pose.heading + 0.3);
      continue;
    }
    pose = next;
    path.push_back(pose);
  }
  return path;
}

Place& place(const benchmark::State& state) {
  static std::map<std::pair<std::int64_t, std::int64_t>, Place> cache;
  auto [it, fresh] = cache.try_emplace({state.range(0), state.range(1)});
  Place& made = it->second;
  if (!fresh) return made;
  Stream random(7, "bench");
  World world;
  const int walls = static_cast<int>(state.range(1));
  const double side = state.range(0) != 0 ? fill_rooms(world, walls, random) : fill_hall(world, walls, random);
  made.scene.follow(world);
  std::vector<Pole> poles;
  made.scene.walls().gather({0, 0}, 1e6, made.walls, poles);
  made.path = wander(made.scene.walls(), side, 2000, random);
  return made;
}

/// Runs one scan per iteration and notes the ratio to the baseline. Returns the seconds per scan.
template <class Scan>
double run(benchmark::State& state, Place& here, const Scan& scan) {
  std::size_t i = 1;
  const std::clock_t start = std::clock();  // of the processor: the machine may be busy
  for (auto _ : state) {
    scan(i);
    if (++i == here.path.size()) i = 1;
  }
  const double seconds =
      static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(state.iterations());
  if (here.brute_seconds > 0) state.counters["brute/this"] = here.brute_seconds / seconds;
  state.SetLabel(fmt::format("{} walls", here.walls.size()));
  return seconds;
}

template <class Cast>
double bundles(const Pose2& pose, const Cast& cast) {
  const SonarOptions options;
  double sum = 0;
  for (int i = 0; i < kCount; ++i)
    for (int k = 0; k < kRaysPerCone; ++k) {
      const double axis = pose.heading + 2 * kPi * i / kCount;
      const SinCos a = sin_cos(axis), r = sin_cos(axis + options.half_cone * (k - 4) / 4.0);
      sum += cast(pose.position() + 0.23 * Vec2(a.cos, a.sin), Vec2(r.cos, r.sin), options.range_max);
    }
  return sum;
}

double cast_all(const std::vector<Wall>& walls, const Vec2& o, const Vec2& u, double most) {
  for (const Wall& wall : walls) {
    const Vec2 a = wall.a - o, b = wall.b - o;
    const double side_a = cross(u, a), side_b = cross(u, b);
    if ((side_a > 0) == (side_b > 0)) continue;
    const double range = (u.dot(a) * side_b - u.dot(b) * side_a) / (side_b - side_a);
    if (range > 0 && range < most) most = range;
  }
  return most;
}

void brute(benchmark::State& state) {
  Place& here = place(state);
  here.brute_seconds = run(state, here, [&](std::size_t i) {
    benchmark::DoNotOptimize(bundles(
        here.path[i], [&](const Vec2& o, const Vec2& u, double most) { return cast_all(here.walls, o, u, most); }));
  });
}

void indexed_rays(benchmark::State& state) {
  Place& here = place(state);
  run(state, here, [&](std::size_t i) {
    benchmark::DoNotOptimize(bundles(here.path[i], [&](const Vec2& o, const Vec2& u, double most) {
      const auto hit = here.scene.walls().cast(o, u, most);
      return hit ? hit->range : most;
    }));
  });
}

SonarOptions cone() {
  SonarOptions o;
  o.incidence = false;
  o.near_field = o.corner_range = o.noise = o.noise_proportional = 0;
  o.firing = Firing::simultaneous;
  return o;
}
SonarOptions incidence() {
  SonarOptions o = cone();
  o.incidence = true;
  return o;
}
SonarOptions near_field() {
  SonarOptions o = incidence();
  o.near_field = SonarOptions{}.near_field;
  return o;
}
SonarOptions corners() {
  SonarOptions o = near_field();
  o.corner_range = SonarOptions{}.corner_range;
  return o;
}
SonarOptions noise() {
  SonarOptions o = corners();
  o.noise = o.noise_proportional = 0.01;
  o.dropout = 0.01, o.spurious = 0.03;
  return o;
}
SonarOptions sequence() {
  SonarOptions o = noise();
  o.firing = Firing::sequence;
  return o;
}
SonarOptions bounce() {
  SonarOptions o = sequence();
  o.bounce = true;
  return o;
}
SonarOptions everything() {
  SonarOptions o = bounce();
  o.firing = Firing::simultaneous;
  o.crosstalk = true;
  return o;
}

void scan(benchmark::State& state, SonarOptions (*effects)()) {
  Place& here = place(state);
  SonarRing ring(RingLayout{}, effects(), 1);
  std::vector<Pose2> poses(kCount);
  std::vector<double> ranges(kCount);
  run(state, here, [&](std::size_t i) {
    const Pose2 &from = here.path[i - 1], &to = here.path[i];
    const double turn = angle_between(from.heading, to.heading);
    for (int k = 0; k < kCount; ++k) {
      const double t = ring.firing_times()[k];
      poses[k] = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), from.heading + t * turn};
    }
    ring.scan(here.scene, poses, SonarRing::kNobody, ranges);
    benchmark::DoNotOptimize(ranges.data());
  });
}

/// The list is gathered anew for every scan: a ring that never scanned before.
void scan_anew(benchmark::State& state) {
  Place& here = place(state);
  std::vector<Pose2> poses(kCount);
  std::vector<double> ranges(kCount);
  SonarRing ring(RingLayout{}, sequence(), 1);
  run(state, here, [&](std::size_t i) {
    std::fill(poses.begin(), poses.end(), here.path[(i * 37) % here.path.size()]);
    ring.scan(here.scene, poses, SonarRing::kNobody, ranges);
    benchmark::DoNotOptimize(ranges.data());
  });
}

void places(benchmark::internal::Benchmark* b) {
  b->ArgNames({"rooms", "walls"})->Unit(benchmark::kMicrosecond);
  for (const int walls : {300, 3000, 20000})
    for (const int rooms : {0, 1}) b->Args({rooms, walls});
}

BENCHMARK(brute)->Apply(places);
BENCHMARK(indexed_rays)->Apply(places);
BENCHMARK_CAPTURE(scan, cone, cone)->Apply(places);
BENCHMARK_CAPTURE(scan, incidence, incidence)->Apply(places);
BENCHMARK_CAPTURE(scan, near_field, near_field)->Apply(places);
BENCHMARK_CAPTURE(scan, corners, corners)->Apply(places);
BENCHMARK_CAPTURE(scan, noise, noise)->Apply(places);
BENCHMARK_CAPTURE(scan, sequence, sequence)->Apply(places);
BENCHMARK_CAPTURE(scan, bounce, bounce)->Apply(places);
BENCHMARK_CAPTURE(scan, everything, everything)->Apply(places);
BENCHMARK(scan_anew)->Apply(places);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

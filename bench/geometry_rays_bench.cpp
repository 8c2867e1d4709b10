// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Single rays, edits and the other queries of ShapeIndex. "brute" is the named baseline: the same ray met with every
// wall.
#include <benchmark/benchmark.h>

#include <map>

#include "base/random.hpp"
#include "geometry/nearest_hit.hpp"
#include "geometry/shape_index.hpp"

namespace meander {
namespace {

constexpr double kRange = 6.477;
constexpr int kRays = 144;  // of one scan

struct Place {
  ShapeIndex index;
  std::vector<Shape> shapes;
  std::vector<Wall> walls;
  std::vector<Vec2> origins;
  std::vector<Vec2> directions;
};

void add(Place& place, const Shape& shape) {
  place.index.insert(static_cast<std::uint32_t>(place.shapes.size()), shape);
  place.shapes.push_back(shape);
}

/// Rotated boxes, 0.75 walls per square metre.
void fill_hall(Place& place, int walls, Stream& random) {
  const double side = std::sqrt(walls / 0.75);
  add(place, Chain{{{0, 0}, {side, 0}, {side, side}, {0, side}}, true});
  for (int i = 0; i < walls / 4; ++i)
    add(place, Rectangle{{random.uniform(0, side), random.uniform(0, side)},
                         {random.uniform(0.3, 1.5), random.uniform(0.3, 1.5)},
                         random.uniform(0, kPi)});
}

/// Rooms of 5 x 4 m with doors of 0.9 m and boxes, 1.6 walls per square metre.
void fill_rooms(Place& place, int walls, Stream& random) {
  const int side = std::max(2, static_cast<int>(std::sqrt(walls / 32.0)));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Vec2 corner(5.0 * x, 4.0 * y);
      const double door = random.uniform(0.5, 2.5);
      add(place, Chain{{corner + Vec2(0, 4), corner, corner + Vec2(door, 0)}, false});
      add(place, Chain{{corner + Vec2(door + 0.9, 0), corner + Vec2(5, 0)}, false});
      for (int box = 0; box < 7; ++box)
        add(place, Rectangle{corner + Vec2(random.uniform(0.3, 4.7), random.uniform(0.3, 3.7)),
                             {random.uniform(0.2, 0.9), random.uniform(0.2, 0.9)},
                             random.uniform(0, kPi)});
    }
}

const Place& place(bool rooms, int walls) {
  static std::map<std::pair<bool, int>, Place> cache;
  auto [it, fresh] = cache.try_emplace({rooms, walls});
  Place& made = it->second;
  if (!fresh) return made;
  Stream random(7, "bench");
  rooms ? fill_rooms(made, walls, random) : fill_hall(made, walls, random);
  std::vector<Pole> poles;
  made.index.gather({0, 0}, 1e6, made.walls, poles);
  const double extent = bounding_box(Chain{{made.walls.front().a, made.walls.back().b}, false}).high.maxCoeff();
  while (made.origins.size() < 256) {
    const Vec2 p(random.uniform(0, extent), random.uniform(0, extent));
    if (!made.index.inside(p) && made.index.distance(p, 1) > 0.25 && made.index.cast(p, {1, 0}, 20))
      made.origins.push_back(p);
  }
  for (int i = 0; i < kRays; ++i) {
    const SinCos t = sin_cos(2 * kPi * (i + 0.37) / kRays);
    made.directions.emplace_back(t.cos, t.sin);
  }
  return made;
}

void label(benchmark::State& state, const Place& place) {
  state.SetLabel(fmt::format("{} walls", place.walls.size()));
  state.counters["rays/s"] =
      benchmark::Counter(static_cast<double>(state.iterations() * kRays), benchmark::Counter::kIsRate);
}

void brute(benchmark::State& state) {
  const Place& here = place(state.range(0) != 0, static_cast<int>(state.range(1)));
  std::size_t i = 0;
  for (auto _ : state) {
    const Vec2& origin = here.origins[i++ % here.origins.size()];
    double sum = 0;
    for (const Vec2& direction : here.directions) {
      NearestHit nearest(origin, direction, kRange);
      for (const Wall& wall : here.walls) nearest.meet_wall(wall.a - origin, wall.b - origin, wall.owner);
      sum += nearest.range();
    }
    benchmark::DoNotOptimize(sum);
  }
  label(state, here);
}

void cast(benchmark::State& state) {
  const Place& here = place(state.range(0) != 0, static_cast<int>(state.range(1)));
  std::size_t i = 0;
  for (auto _ : state) {
    const Vec2& origin = here.origins[i++ % here.origins.size()];
    double sum = 0;
    for (const Vec2& direction : here.directions) {
      const auto hit = here.index.cast(origin, direction, kRange);
      sum += hit ? hit->range : kRange;
    }
    benchmark::DoNotOptimize(sum);
  }
  label(state, here);
}

void gather(benchmark::State& state) {
  const Place& here = place(state.range(0) != 0, static_cast<int>(state.range(1)));
  std::size_t i = 0;
  std::vector<Wall> walls;
  std::vector<Pole> poles;
  for (auto _ : state) {
    here.index.gather(here.origins[i++ % here.origins.size()], kRange + 0.73, walls, poles);
    benchmark::DoNotOptimize(walls.data());
  }
}

void distance(benchmark::State& state) {
  const Place& here = place(state.range(0) != 0, static_cast<int>(state.range(1)));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(here.index.distance(here.origins[i++ % here.origins.size()], 10));
}

void distance_in_the_open(benchmark::State& state) {
  ShapeIndex index;
  index.insert(0, Chain{{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, true});
  for (auto _ : state) benchmark::DoNotOptimize(index.distance({0.3, 0.4}, 10));
}

void inside(benchmark::State& state) {
  const Place& here = place(state.range(0) != 0, static_cast<int>(state.range(1)));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(here.index.inside(here.origins[i++ % here.origins.size()]));
}

/// Takes out a box and puts it in elsewhere.
void move(benchmark::State& state) {
  const Place& here = place(false, static_cast<int>(state.range(0)));
  ShapeIndex index = here.index;
  std::vector<Shape> there;
  for (const Shape& shape : here.shapes) there.push_back(moved(shape, {0.6, -0.4}));
  std::uint32_t owner = 0;
  for (auto _ : state) {
    owner = owner % static_cast<std::uint32_t>(there.size() - 1) + 1;
    index.remove(owner);
    index.insert(owner, there[owner]);
  }
}

void insert_all(benchmark::State& state) {
  const Place& here = place(false, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    ShapeIndex index;
    for (std::uint32_t i = 0; i < here.shapes.size(); ++i) index.insert(i, here.shapes[i]);
    benchmark::DoNotOptimize(index.wall_count());
  }
}

void copy(benchmark::State& state) {
  const Place& here = place(false, static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ShapeIndex(here.index).wall_count());
}

void places(benchmark::internal::Benchmark* b) {
  b->ArgNames({"rooms", "walls"});
  for (const int walls : {300, 3000, 20000})
    for (const int rooms : {0, 1}) b->Args({rooms, walls});
}

BENCHMARK(brute)->Apply(places)->Unit(benchmark::kMicrosecond);
BENCHMARK(cast)->Apply(places)->Unit(benchmark::kMicrosecond);
BENCHMARK(gather)->Apply(places);
BENCHMARK(distance)->Apply(places);
BENCHMARK(distance_in_the_open);
BENCHMARK(inside)->Apply(places);
BENCHMARK(move)->Arg(300)->Arg(3000)->Arg(20000);
BENCHMARK(insert_all)->Arg(300)->Arg(3000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK(copy)->Arg(300)->Arg(3000)->Arg(20000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace meander

BENCHMARK_MAIN();

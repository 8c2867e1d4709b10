// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What a sample costs a topologic map, and a presentation its net, while the robot drives all over it. The map of 50
// cells is the named baseline: the counter "this/50" is the ratio to it, the ratio that must not grow.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "topology/topologic_map.hpp"

namespace meander::topology {
namespace {

constexpr double kSpacing = 0.3;  ///< of the cells [m]
constexpr double kStep = 0.05;    ///< of the robot [m]
constexpr int kOld = -1000;       ///< the cells were born long ago

/// A square full of cells, and a robot that bounces about in it and senses what the cells say, with noise.
class Ground {
 public:
  explicit Ground(int cells) : map_({}, {}), stream_(1, "ground") {
    const int side = static_cast<int>(std::ceil(std::sqrt(cells)));
    size_ = (side - 1) * kSpacing;
    std::vector<float> senses(static_cast<std::size_t>(map_.net().metric().stride()));
    for (int i = 0; i < cells; ++i) {
      const Vec2 at(i % side * kSpacing, i / side * kSpacing);
      fill(at, senses);
      map_.net().insert({at, senses.data()}, kOld, i % side > 0 ? i - 1 : -1);
      if (i >= side) map_.net().cells().connect(i, i - side, {});
    }
    observation_.readings.whisker.resize(24);
    observation_.readings.light.resize(24);
    observation_.odometry.pose = {0.5 * size_, 0.5 * size_, 0};
    row_.resize(senses.size());
  }

  void drive() {
    Pose2& at = observation_.odometry.pose;
    const SinCos way = sin_cos(way_);
    const Vec2 next = at.position() + kStep * Vec2(way.cos, way.sin);
    if (next.x() < 0 || next.y() < 0 || next.x() > size_ || next.y() > size_) {
      way_ = angle_of(0.5 * size_ - at.y, 0.5 * size_ - at.x) + stream_.uniform(-1, 1);
    } else {
      at.x = next.x();
      at.y = next.y();
    }
    fill(next, row_);
    for (std::size_t i = 0; i < 24; ++i) {
      observation_.readings.whisker[i] = stream_.chance(0.01);
      observation_.readings.light[i] = row_[24 + i] + stream_.normal(0, 0.01);
    }
  }
  void step() { map_.step(observation_); }
  Match present() {
    const Situation now{observation_.odometry.pose.position(), row_.data()};
    return map_.net().present(now, 0);
  }
  const TopologicMap& map() const { return map_; }

 private:
  /// Light that changes slowly from place to place, no contacts.
  static void fill(const Vec2& at, std::vector<float>& senses) {
    for (std::size_t i = 0; i < 24; ++i)
      senses[24 + i] = static_cast<float>(0.5 + 0.1 * sin_cos(wrap_angle(at.x() + 0.7 * at.y() + 0.2 * i)).sin);
  }

  TopologicMap map_;
  Stream stream_;
  Observation observation_;
  std::vector<float> row_;
  double size_ = 0, way_ = 0.4;
};

template <class Body>
void run(benchmark::State& state, double& baseline, const Body& body) {
  Ground ground(static_cast<int>(state.range(0)));
  for (int i = 0; i < 2000; ++i) ground.drive(), ground.step();
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    ground.drive();
    body(ground);
  }
  const double seconds =
      static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(state.iterations());
  if (state.range(0) == 50) baseline = seconds;
  if (baseline > 0) state.counters["this/50"] = seconds / baseline;
  state.counters["cells"] = ground.map().net().cells().size();
}

/// What of the others is the robot's own.
void driving(benchmark::State& state) {
  static double baseline = 0;
  run(state, baseline, [](Ground&) {});
}
void presentation(benchmark::State& state) {
  static double baseline = 0;
  run(state, baseline, [](Ground& ground) { benchmark::DoNotOptimize(ground.present()); });
}
void sample(benchmark::State& state) {
  static double baseline = 0;
  run(state, baseline, [](Ground& ground) { ground.step(); });
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgName("cells")->Unit(benchmark::kMicrosecond)->Arg(50)->Arg(1000)->Arg(10'000)->Arg(100'000);
}
BENCHMARK(driving)->Apply(sizes);
BENCHMARK(presentation)->Apply(sizes);
BENCHMARK(sample)->Apply(sizes);

}  // namespace
}  // namespace meander::topology

BENCHMARK_MAIN();

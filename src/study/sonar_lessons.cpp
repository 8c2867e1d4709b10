// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/sonar_lessons.hpp"

#include <cmath>

#include "study/map_truth.hpp"

namespace meander {
namespace {

constexpr std::size_t kMostLessons = 10'000'000;  ///< a few hundred megabytes, with what a network makes of them

/// Random poses where the body has room.
class PoseSource {
 public:
  PoseSource(const World& world, double radius, std::uint64_t seed)
      : bounds_(world.header().bounds), radius_(radius), stream_(seed, "lessons.poses") {
    for (const Id id : world.ids())
      if (const Shape* shape = blocking_shape(world.item(id))) walls_.insert(id.slot, *shape);
  }

  Pose2 next() {
    constexpr int kTries = 10000;
    constexpr double kRoom = 0.02;  ///< beside the body [m]
    for (int i = 0; i < kTries; ++i) {
      const double x = stream_.uniform(bounds_.low.x(), bounds_.high.x());
      const double y = stream_.uniform(bounds_.low.y(), bounds_.high.y());
      const double heading = stream_.uniform(-kPi, kPi), need = radius_ + kRoom;
      if (walls_.distance({x, y}, need) >= need && !walls_.inside({x, y})) return {x, y, heading};
    }
    fail("lessons: the world has no room for a robot of radius {} m", radius_);
  }

 private:
  Box bounds_;
  double radius_;
  Stream stream_;
  ShapeIndex walls_;
};

/// The cells of the window, whose borders are multiples of the resolution in the world, as those of a local map.
Grid<CellTruth> truth_around(const Sim& sim, const LessonOptions& options) {
  const Vec2 at = sim.state().pose_world.position() / options.resolution;
  const int half = options.window / 2;
  GridFrame frame{.resolution = options.resolution, .origin = {}};
  frame.origin.x = options.resolution * (std::floor(at.x()) - half);
  frame.origin.y = options.resolution * (std::floor(at.y()) - half);
  return map_truth(sim, 0, options.window, options.window, frame, {.slack = options.slack});
}

double share_of(CellTruth truth, const LessonOptions& options) {
  if (truth == CellTruth::occupied) return options.occupied;
  return truth == CellTruth::free ? options.free : options.hidden;
}

void add_scan(SonarLessons& lessons, const Sim& sim, const LessonOptions& options, Stream& choice) {
  const auto scan = static_cast<std::uint32_t>(lessons.scans());
  const std::vector<double>& ranges = sim.observation().readings.sonar;
  lessons.ranges.insert(lessons.ranges.end(), ranges.begin(), ranges.end());
  const Grid<CellTruth> truth = truth_around(sim, options);
  const Pose2 robot_from_world = inverse(sim.state().pose_world);
  const Box& bounds = sim.world().header().bounds;
  const double body = sim.robot().platform.body.radius;
  if (lessons.cells.size() > kMostLessons)
    fail("lessons: {} cells at most expected: fewer poses or smaller shares", kMostLessons);
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      const CellTruth cell = truth[{x, y}];
      if (!choice.chance(share_of(cell, options))) continue;
      const Vec2 center = truth.frame.center({x, y}), seen = robot_from_world * center;
      if (!bounds.contains(center) || seen.norm() <= body) continue;
      lessons.cells.push_back({.scan = scan,
                               .range = static_cast<float>(seen.norm()),
                               .bearing = static_cast<float>(angle_of(seen.y(), seen.x())),
                               .truth = cell});
    }
}

void check(const SonarLessons& lessons, const RobotOptions& robot) {
  const RingLayout &before = lessons.ring, &ring = robot.platform.sonar;
  if (before.count != ring.count || before.radius != ring.radius || before.first != ring.first ||
      lessons.range_max != robot.sonar.range_max)
    fail("lessons: the sonar ring that they began with expected, got another");
}

}  // namespace

void add_lessons(SonarLessons& lessons, const World& world, const RobotOptions& robot, const LessonOptions& options,
                 const Work& work) {
  validate(options);
  if (lessons.ranges.empty()) {
    lessons.ring = robot.platform.sonar;
    lessons.range_max = robot.sonar.range_max;
  }
  check(lessons, robot);
  const auto shared = std::make_shared<World>(world);
  PoseSource poses(world, robot.platform.body.radius, options.seed);
  Stream choice(options.seed, "lessons.cells");
  RobotOptions placed = robot;
  for (int i = 0; i < options.poses; ++i) {
    work.poll();
    placed.start = poses.next();
    // A seed for each pose: readings that a sonar holds or repeats belong to one place.
    const Sim sim(shared, {placed}, {.seed = trial_seed(options.seed, static_cast<std::uint64_t>(i))});
    add_scan(lessons, sim, options, choice);
    work.report((i + 1.0) / options.poses, "looking around");
  }
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sim/sim_robot.hpp"

#include <algorithm>
#include <cmath>

#include "robot/kinematics.hpp"
#include "sensor/bumper.hpp"

namespace meander {
namespace {

/// Bumpers give way this far before they touch [m].
constexpr double kBumperReach = 1e-3;
}  // namespace

SimRobot::SimRobot(const RobotOptions& options, const Pose2& start, std::uint32_t self, int command_delay,
                   std::uint64_t seed)
    : options_(options),
      self_(self),
      sonar_(options.platform.sonar, options.sonar, seed),
      whiskers_(options.platform.whisker, options.whisker, seed),
      lights_(options.platform.light, options.light, seed),
      drift_(options.drift, seed, options.platform.body.drive),
      queue_(static_cast<std::size_t>(command_delay)) {
  const auto sonars = static_cast<std::size_t>(options.platform.sonar.count);
  state_.pose_world = {start.x, start.y, wrap_angle(start.heading)};
  observation_.odometry.pose = state_.pose_world;
  observation_.readings.sonar.resize(sonars);
  observation_.readings.sonar_pose.resize(sonars);
  observation_.readings.sonar_max = options.sonar.range_max;
  observation_.readings.bumper.resize(static_cast<std::size_t>(options.platform.bumper.count));
  observation_.readings.whisker.resize(static_cast<std::size_t>(options.platform.whisker.count));
  observation_.readings.light.resize(static_cast<std::size_t>(options.platform.light.count));
  firing_world_.resize(sonars);
  track_world_.assign(1, state_.pose_world);
  track_odometry_.assign(1, state_.pose_world);
}

void SimRobot::begin_cycle(const Command& command, double period) {
  const Body& body = options_.platform.body;
  reach_ = std::max(body.v_max, -body.v_min) * period;
  queue_.push_back(limited(command, body));
  command_ = queue_.front();
  queue_.erase(queue_.begin());
  near_known_ = false;
  track_world_.assign(1, state_.pose_world);
  track_odometry_.assign(1, observation_.odometry.pose);
}

void SimRobot::move(const Scene& scene, std::span<const Vec2> strides, double dt) {
  const Body& body = options_.platform.body;
  const RampedPlane v = ramped({state_.v, state_.vy}, {command_.v, command_.vy}, body.a_v, dt);
  const Ramped w = ramped(state_.w, command_.w, body.a_w, dt);
  const Pose2 from = state_.pose_world;
  Pose2 to = twist(from, v.mean.x(), v.mean.y(), w.mean, dt);
  stride_ = to.position() - from.position();
  const double share = way(scene, strides, stride_);
  if (share < 1) {  // stopped at the surface; turning on the spot goes on
    to.x = from.x + share * stride_.x();
    to.y = from.y + share * stride_.y();
  }
  const double speed = v.mean.y() == 0 ? std::abs(v.mean.x()) : v.mean.norm();
  const double driven = speed * dt * std::min(share, 1.0);
  state_.v = share < 1 ? 0 : v.end.x();
  state_.vy = share < 1 ? 0 : v.end.y();
  state_.w = w.end;
  state_.travelled += driven;
  state_.pose_world = to;
  room_ -= driven;
  track_world_.push_back(to);
  track_odometry_.push_back(drift_.advance(track_odometry_.back(), from, to));
}

double SimRobot::way(const Scene& scene, std::span<const Vec2> strides, const Vec2& by) {
  const Vec2 from = state_.pose_world.position();
  double share = buried_ ? way_out_of_solid(scene.walls(), by) : way_among_walls(scene.walls(), by);
  if (share < 1) touch(true);
  for (std::size_t k = 0; k < scene.moving.size(); ++k) {
    const Pole& other = scene.moving[k];
    if (other.owner == self_) continue;
    const double reach = radius() + other.disc.radius;
    const double free = way_to_point(from, by, reach + kContactSkin, other.disc.center);
    const Vec2 towards_me = from - other.disc.center;
    const bool came = strides[k].dot(towards_me) > 1e-12;  // it moved into us: not our fault
    if (free < 1)
      touch(!came);
    else if (towards_me.squaredNorm() <= (reach + kContactGap) * (reach + kContactGap))
      touch(false);
    share = std::min(share, free);
  }
  return share;
}

double SimRobot::way_among_walls(const ShapeIndex& walls, const Vec2& by) {
  if (room_ > by.norm() + kContactSkin) return kFreeWay;  // the next wall is out of reach
  if (!near_known_) {
    near_.gather(walls, state_.pose_world.position(), radius() + reach_ + kContactGap);
    near_known_ = true;
  }
  return near_.way(state_.pose_world.position(), by, radius());
}

double SimRobot::way_out_of_solid(const ShapeIndex& walls, const Vec2& by) const {
  const auto depth = [&](const Vec2& p) { return walls.inside(p) ? walls.distance(p, 1e6) : 0.0; };
  const Vec2 from = state_.pose_world.position();
  return depth(from + by) <= depth(from) ? kFreeWay : 0;
}

void SimRobot::touch(bool own_fault) {
  if (in_contact_) return;
  in_contact_ = true;
  ++state_.contacts;
  state_.fault_contacts += own_fault;
}

void SimRobot::look_again(const Scene& scene) {
  buried_ = scene.walls().inside(state_.pose_world.position());
  room_ = 0;
}

void SimRobot::measure_clearance(const Scene& scene) {
  const Vec2 at = state_.pose_world.position();
  if (buried_) buried_ = scene.walls().inside(at);
  double gap = kClearanceSeen;
  for (const Pole& other : scene.moving)
    if (other.owner != self_) gap = std::min(gap, (at - other.disc.center).norm() - other.disc.radius - radius());
  const double wall = scene.walls().distance(at, std::max(gap, 0.0) + radius());
  room_ = buried_ ? 0 : wall - radius();
  state_.clearance = std::min(gap, buried_ ? -wall - radius() : wall - radius());
  state_.touching = state_.clearance <= kContactGap;
  if (state_.touching) touch(false);
  if (state_.clearance > kContactRelease) in_contact_ = false;
}

void SimRobot::scan(const Scene& scene) {
  const auto times = sonar_.firing_times();
  Readings& readings = observation_.readings;
  const std::size_t parts = track_world_.size() - 1;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double at = times[i] * static_cast<double>(parts);
    const std::size_t part = std::min(static_cast<std::size_t>(at), parts > 0 ? parts - 1 : 0);
    const std::size_t next = std::min(part + 1, parts);
    const double share = at - static_cast<double>(part);
    firing_world_[i] = between(track_world_[part], track_world_[next], share);
    readings.sonar_pose[i] = between(track_odometry_[part], track_odometry_[next], share);
  }
  sonar_.scan(scene, firing_world_, self_, readings.sonar);
}

void SimRobot::sense(const Scene& scene, double time, double period) {
  measure_clearance(scene);
  observation_.time = time;
  observation_.period = period;
  observation_.odometry = {track_odometry_.back(), state_.v, state_.w, state_.vy};
  scan(scene);
  auto& bumper = observation_.readings.bumper;
  if (state_.clearance > kBumperReach)
    std::fill(bumper.begin(), bumper.end(), std::uint8_t{0});
  else
    read_bumpers(scene, options_.platform.bumper, kBumperReach, state_.pose_world, self_, bumper);
  whiskers_.read(scene, state_.pose_world, self_, observation_.readings.whisker);
  lights_.read(scene, state_.pose_world, self_, observation_.readings.light);
}

void SimRobot::add_to(Hash& hash) const {
  const auto add_pose = [&](const Pose2& p) { hash.add(p.x).add(p.y).add(p.heading); };
  const auto flag = [](bool b) { return std::uint64_t{b}; };
  add_pose(state_.pose_world);
  add_pose(observation_.odometry.pose);
  hash.add(state_.v).add(state_.w).add(state_.travelled).add(state_.clearance);
  hash.add(static_cast<std::uint64_t>(state_.contacts)).add(static_cast<std::uint64_t>(state_.fault_contacts));
  hash.add(flag(state_.touching)).add(flag(in_contact_)).add(flag(buried_));
  for (const Command& command : queue_) hash.add(command.v).add(command.w);
  for (const double range : observation_.readings.sonar) hash.add(range);
  for (const std::uint8_t pressed : observation_.readings.bumper) hash.add(std::uint64_t{pressed});
  sonar_.add_to(hash);
  drift_.add_to(hash);
  add_further(hash);
}

/// What only some platforms have.
void SimRobot::add_further(Hash& hash) const {
  const Platform& platform = options_.platform;
  if (platform.body.drive == DriveKind::omnidirectional) {
    hash.add(state_.vy);
    for (const Command& command : queue_) hash.add(command.vy);
  }
  if (platform.whisker.count > 0) whiskers_.add_to(hash);
  if (platform.light.count > 0) lights_.add_to(hash);
  for (const std::uint8_t bent : observation_.readings.whisker) hash.add(std::uint64_t{bent});
  for (const double brightness : observation_.readings.light) hash.add(brightness);
}

}  // namespace meander

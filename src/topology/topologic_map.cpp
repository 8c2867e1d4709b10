// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/topologic_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace meander::topology {
namespace {

const TopologicMapOptions& checked(const TopologicMapOptions& options) {
  validate(options);
  return options;
}

const SenseSuite& checked(const SenseSuite& suite) {
  if (suite.whiskers < 1 || suite.lights < 0)
    fail("topologic map: a robot with whiskers expected, got {} and {} light sensors", suite.whiskers, suite.lights);
  return suite;
}

void check_ahead(const Platform& robot, const char* name, const RingLayout& ring) {
  if (ring.count > 0 && ring.first != 0)
    fail("robot '{}': {}.first = 0 expected, the first one ahead; got {}", robot.name, name, ring.first);
}

constexpr double kFarthest = 1e6;  ///< [m] and [rad]

void check_near(double number) {
  if (!(std::abs(number) <= kFarthest)) fail("a number from -1e6 to 1e6 expected, got {}", number);
}

}  // namespace

void check_whiskers(const Platform& robot) {
  if (robot.whisker.count < 1) fail("robot '{}' has no whiskers; one like 'alice' expected", robot.name);
  check_ahead(robot, "whisker", robot.whisker);
}

SenseSuite sense_suite(const Platform& robot, double whisker_reach) {
  check_whiskers(robot);
  check_ahead(robot, "light", robot.light);
  return {robot.whisker.count, robot.light.count, robot.whisker.radius, whisker_reach};
}

TopologicMap::TopologicMap(const TopologicMapOptions& options, const SenseSuite& suite)
    : options_(checked(options)),
      suite_(checked(suite)),
      metric_(suite.whiskers, suite.lights, options.scales),
      smoother_(suite.whiskers, options.touch_smoothing),
      net_(options.net, metric_, options.scales.position),
      correlation_(options.correlation, metric_),
      doubt_(options.doubt, suite.whisker_radius, suite.whisker_reach),
      queue_(static_cast<std::size_t>(options.delay) + 1),
      touch_(static_cast<std::size_t>(suite.whiskers)),
      light_(static_cast<std::size_t>(suite.lights)) {
  now_.resize(static_cast<std::size_t>(metric_.stride()));
  for (Waiting& place : queue_) place.senses.resize(static_cast<std::size_t>(metric_.stride()));
}

void TopologicMap::step(const Observation& observation) {
  check_rings(observation.readings);
  if (!learning_) break_off();
  learning_ = true;
  localise(observation);
  remember();  // the learning set of [Z] section 3-2
  const std::uint64_t told = serial_of(correction_.cell);
  learn();                                                         // [Z] sections 3-2 and 3-3
  if (serial_of(correction_.cell) != told) correction_.cell = -1;  // learning removed it
  ++samples_;
}

void TopologicMap::follow(const Observation& observation) {
  check_rings(observation.readings);
  learning_ = false;
  localise(observation);
  ++samples_;
}

void TopologicMap::localise(const Observation& observation) {
  dead_reckon(observation.odometry.pose);
  sense(observation.readings);  // [Z] section 3-1
  correlate();                  // [Z] section 3-4
  senses_of(rings(), pose_.heading, now_);
  doubt_.judge(net_, pose_, observation.readings.whisker, samples_);
}

void TopologicMap::break_off() {
  net_.break_off();
  learnt_from_ = samples_;
}

void TopologicMap::begin(const std::optional<Pose2>& pose) {
  if (pose)
    for (const double number : {pose->x, pose->y, pose->heading}) check_near(number);
  break_off();
  recognition_ = {};
  correction_ = {};
  if (pose) pose_ = {pose->x, pose->y, wrap_angle(pose->heading)};
  begins_ = pose || samples_ > 0;  // the first sample of all says itself where it is
}

void TopologicMap::shift(const Vec2& by) {
  for (const double number : {by.x(), by.y()}) check_near(number);
  break_off();
  pose_.x += by.x();
  pose_.y += by.y();
}

void TopologicMap::dead_reckon(const Pose2& odometry) {
  if (!begins_) pose_ = samples_ == 0 ? odometry : pose_ * (inverse(odometry_) * odometry);
  begins_ = false;
  odometry_ = odometry;
}

void TopologicMap::check_rings(const Readings& readings) const {
  if (readings.whisker.size() != touch_.size() || readings.light.size() != light_.size())
    fail("topologic map for {} whiskers and {} light sensors: got {} and {}", touch_.size(), light_.size(),
         readings.whisker.size(), readings.light.size());
}

void TopologicMap::sense(const Readings& readings) {
  smoother_.smooth(readings.whisker, touch_);
  for (std::size_t i = 0; i < light_.size(); ++i) light_[i] = static_cast<float>(readings.light[i]);
}

void TopologicMap::correlate() {
  correction_ = {};
  if (options_.correlation.gain == 0) return;
  correction_ = correlation_.correct(net_, pose_, rings(), samples_);
  pose_.x += correction_.shift.x();
  pose_.y += correction_.shift.y();
  pose_.heading = wrap_angle(pose_.heading + correction_.turn);
  // The situations that wait to be learnt came with part of the same error: the newest with all of it.
  const std::int64_t first = std::max(learnt_from_, samples_ - options_.delay);
  const auto parts = static_cast<double>(samples_ - first + 1);
  for (std::int64_t s = first; s < samples_; ++s)
    waiting(s).position += static_cast<double>(s - first + 1) / parts * correction_.shift;
}

void TopologicMap::remember() {
  Waiting& now = waiting(samples_);
  now.position = pose_.position();
  std::copy(now_.begin(), now_.end(), now.senses.begin());
}

void TopologicMap::learn() {
  const std::int64_t sample = samples_ - options_.delay;
  if (sample < learnt_from_) return;
  const Waiting& shown = waiting(sample);
  for (int k = 0; k < options_.presentations; ++k) {
    const Match match = net_.present({shown.position, shown.senses.data()}, sample);
    recognition_ = {sample, match.cell, match.distance};
  }
}

}  // namespace meander::topology

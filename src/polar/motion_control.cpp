// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/motion_control.hpp"

#include <algorithm>
#include <cmath>

#include "robot/kinematics.hpp"

namespace meander {
namespace {

Vec2 direction(double angle) {
  const SinCos t = sin_cos(angle);
  return {t.cos, t.sin};
}

/// Chord of an arc of length 1 that begins with this heading and turns by `turn`.
Vec2 chord(double heading, double turn) {
  const double half = 0.5 * turn;
  return (half == 0 ? 1.0 : sin_cos(half).sin / half) * direction(heading + half);
}

int samples_of(double way, double step) { return static_cast<int>(std::ceil(way / step - 1e-9)); }

}  // namespace

MotionControl::MotionControl(const Body& body, const MotionControlOptions& options, OwnObjective own)
    : body_(body), options_(options), own_(std::move(own)) {
  speeds_.resize(static_cast<std::size_t>(options.speeds));
  turns_.resize(static_cast<std::size_t>(options.turns));
  strides_.resize(turns_.size() * 2 * static_cast<std::size_t>(options.samples + 1));
  open_.reserve(speeds_.size() * turns_.size());
}

/// [LM99] 1: the velocities that can be reached within one control period, sampled.
void MotionControl::make_window(const MotionTask& task) {
  for (Stride& stride : strides_) stride.known = false;
  const double dt = task.now.period;
  const double v_least = std::clamp(task.now.v - body_.a_v * dt, 0.0, body_.v_max);
  const double v_most = std::clamp(task.now.v + body_.a_v * dt, 0.0, body_.v_max);
  for (std::size_t k = 0; k < speeds_.size(); ++k) {
    const double v = v_least + (v_most - v_least) * static_cast<double>(k) / static_cast<double>(speeds_.size() - 1);
    speeds_[k] = {v, std::max(0.0, ramped(task.now.v, v, body_.a_v, dt).mean * dt), v * v / (2 * body_.a_v)};
  }
  const double w_least = std::clamp(task.now.w - body_.a_w * dt, -body_.w_max, body_.w_max);
  const double w_most = std::clamp(task.now.w + body_.a_w * dt, -body_.w_max, body_.w_max);
  for (std::size_t k = 0; k < turns_.size(); ++k) {
    Turn& turn = turns_[k];
    turn.w = w_least + (w_most - w_least) * static_cast<double>(k) / static_cast<double>(turns_.size() - 1);
    turn.driven = ramped(task.now.w, turn.w, body_.a_w, dt).mean * dt;
    turn.braked = turn.w * std::abs(turn.w) / (2 * body_.a_w);
    turn.drive = chord(task.heading, turn.driven);
    turn.brake = chord(task.heading + turn.driven, turn.braked);
    turn.heading = wrap_angle(task.heading + turn.driven + turn.braked);
  }
}

/// [LM99] 2: where the pair ends, after the period and the least way to a stop.
MotionCandidate MotionControl::candidate(const MotionTask& task, int index) const {
  const Speed& speed = speeds_[static_cast<std::size_t>(index) / turns_.size()];
  const Turn& turn = turns_[static_cast<std::size_t>(index) % turns_.size()];
  const Vec2 end = speed.driven * turn.drive + speed.braked * turn.brake;
  MotionCandidate candidate;
  candidate.command = {speed.v, turn.w, 0};
  candidate.end = {end.x(), end.y(), turn.heading};
  candidate.distance = (task.subgoal - end).norm();
  candidate.near = task.clearance < options_.near_margin;
  return candidate;
}

void MotionControl::aim(const MotionTask& task, MotionCandidate& candidate) const {
  const Vec2 way = task.subgoal - candidate.end.position();
  candidate.heading_error = std::abs(angle_between(candidate.end.heading, angle_of(way.y(), way.x())));
}

double MotionControl::heading_cost(const MotionCandidate& c) const {
  return options_.heading_cost * c.heading_error * std::min(1.0, c.distance / options_.heading_reach);
}

double MotionControl::free_cost(const MotionCandidate& c) const { return c.distance + heading_cost(c); }

double MotionControl::hard_cost(const MotionCandidate& c) const {
  if (c.hard == 0) return 0;
  return options_.hard_cost * (options_.hard_base + c.command.v / std::max(body_.v_max, 1e-9)) +
         options_.hard_samples * c.hard;
}

double MotionControl::soft_cost(const MotionCandidate& c) const { return options_.soft_samples * c.soft / 8; }

double MotionControl::speed_cost(const MotionCandidate& c) const {
  return options_.soft_speed_cost * (c.near ? 1.0 : static_cast<double>(c.soft) / c.samples) *
         std::max(0.0, c.command.v - options_.soft_speed) / std::max(body_.v_max, 1e-9);
}

/// [LM99+] Obstacles along the trajectory count one by one, not by their density: near a wall a longer trajectory has
/// the lower density, and the robot would speed up. The soft zone makes slow, it does not forbid.
double MotionControl::obstacle_cost(const MotionCandidate& c) const {
  if (c.soft == 0 && c.hard == 0 && !c.near) return 0;
  return soft_cost(c) + speed_cost(c) + hard_cost(c);
}

MotionCost MotionControl::cost(const MotionCandidate& c) const {
  return {c.distance, heading_cost(c), hard_cost(c), soft_cost(c), speed_cost(c)};
}

double MotionControl::objective(const MotionCandidate& candidate) const {
  return free_cost(candidate) + obstacle_cost(candidate);
}

/// Is the trajectory in the way of something there? False beyond the scope.
bool MotionControl::sample(const MotionTask& task, const Vec2& at, MotionCandidate& candidate) const {
  const double r = at.norm();
  if (r >= task.layout.scope()) return false;
  const int ring = task.layout.nearest_ring(r);
  const int sector = task.layout.nearest_sector(coarse_angle(at.y(), at.x()));
  const bool soft = task.soft.test(ring, sector), hard = task.hard.test(ring, sector);
  candidate.soft += soft;
  candidate.hard += hard;
  return soft || hard;
}

/// Candidates that turn alike share the shape of their arcs.
const MotionControl::Stride& MotionControl::stride(std::size_t turn, bool braking, int count, double heading,
                                                   double turned) {
  Stride& stride =
      strides_[(2 * turn + braking) * static_cast<std::size_t>(options_.samples + 1) + static_cast<std::size_t>(count)];
  if (!stride.known) stride = {chord(heading, turned / count) / count, sin_cos(turned / count), true};
  return stride;
}

/// Follows the trajectory until its cost exceeds `most`.
void MotionControl::look(const MotionTask& task, int index, MotionCandidate& candidate, double free, double most) {
  const Speed& speed = speeds_[static_cast<std::size_t>(index) / turns_.size()];
  const std::size_t which = static_cast<std::size_t>(index) % turns_.size();
  const Turn& turn = turns_[which];
  const double step = std::max(options_.sample_step, (speed.driven + speed.braked) / std::max(1, options_.samples - 1));
  const int driving = samples_of(speed.driven, step), braking = samples_of(speed.braked, step);
  candidate.samples = std::max(1, driving + braking);
  Vec2 at(0, 0);
  const auto follow = [&](const Stride& shape, int count, double way) {
    Vec2 stride = way * shape.chord;
    for (int k = 0; k < count; ++k) {
      at += stride;
      stride = {shape.turn.cos * stride.x() - shape.turn.sin * stride.y(),
                shape.turn.sin * stride.x() + shape.turn.cos * stride.y()};
      if (sample(task, at, candidate) && free + obstacle_cost(candidate) >= most) return false;
    }
    return true;
  };
  if (driving > 0 && !follow(stride(which, false, driving, task.heading, turn.driven), driving, speed.driven)) return;
  if (braking > 0) follow(stride(which, true, braking, task.heading + turn.driven, turn.braked), braking, speed.braked);
}

double MotionControl::reach(const Prediction& now) const {
  const double v = std::min(now.v + body_.a_v * now.period, body_.v_max);
  return v * now.period + v * v / (2 * body_.a_v);
}

/// At least this is what a candidate costs, found without its trajectory and without an exact angle.
double MotionControl::bound(const MotionTask& task, const MotionCandidate& c) const {
  const Vec2 way = task.subgoal - c.end.position();
  const double error = std::abs(angle_between(c.end.heading, coarse_angle(way.y(), way.x())));
  MotionCandidate best = c;
  best.heading_error = std::max(0.0, error - kCoarse);
  return free_cost(best) + obstacle_cost(best);
}

/// [LM99] 3: the pair with the least value. Candidates come by what they cost at least, the cheapest first, and their
/// trajectories are followed only until they cost more than the best so far: the same answer as looking at all.
Command MotionControl::choose(const MotionTask& task) {
  make_window(task);
  best_ = {};  // stands if an objective of one's own likes nothing
  const int count = static_cast<int>(speeds_.size() * turns_.size());
  const auto later = [](const Open& a, const Open& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.index > b.index;
  };
  open_.clear();
  for (int index = 0; index < count; ++index) open_.push_back({own_ ? 0 : bound(task, candidate(task, index)), index});
  std::make_heap(open_.begin(), open_.end(), later);
  double least = std::numeric_limits<double>::infinity();
  while (!open_.empty() && open_.front().bound < least) {
    const int index = open_.front().index;
    std::pop_heap(open_.begin(), open_.end(), later);
    open_.pop_back();
    MotionCandidate tried = candidate(task, index);
    aim(task, tried);
    const double free = own_ ? 0 : free_cost(tried);
    look(task, index, tried, free, own_ ? std::numeric_limits<double>::infinity() : least);
    const double cost = own_ ? own_(tried) : free + obstacle_cost(tried);
    if (cost < least) {
      least = cost;
      best_ = tried;
    }
  }
  return best_.command;
}

}  // namespace meander

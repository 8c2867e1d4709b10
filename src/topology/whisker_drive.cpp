// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/whisker_drive.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.hpp"
#include "topology/topologic_map.hpp"

namespace meander::topology {
namespace {

/// A corner that held the robot is avoided for so many samples.
constexpr int kHold = 8;

}  // namespace

WhiskerContacts::WhiskerContacts(int whiskers)
    : pitch_(2 * kPi / std::max(whiskers, 1)),
      before_(static_cast<std::size_t>(whiskers)),
      solid_(static_cast<std::size_t>(whiskers)),
      held_(static_cast<std::size_t>(whiskers)) {}

void WhiskerContacts::update(const Observation& seen, std::optional<double> went) {
  const auto& bent = seen.readings.whisker;
  const std::size_t n = before_.size();
  if (bent.size() != n) fail("{} whiskers expected, got {}", n, bent.size());
  if (went && seen.odometry.v == 0 && seen.odometry.vy == 0) {
    const long nearest = std::lround(*went / pitch_), count = static_cast<long>(n);
    held_[static_cast<std::size_t>((nearest % count + count) % count)] = kHold;
  }
  any_ = false;
  for (std::size_t i = 0; i < n; ++i) {
    const bool company = bent[(i + 1) % n] || bent[(i + n - 1) % n] || before_[i];
    solid_[i] = (bent[i] && company) || held_[i] > 0;
    held_[i] -= held_[i] > 0;
    any_ = any_ || solid_[i];
  }
  std::copy(bent.begin(), bent.end(), before_.begin());
}

bool WhiskerContacts::free(double bearing, double half_width) const {
  for (std::size_t i = 0; i < solid_.size(); ++i)
    if (solid_[i] && std::abs(angle_between(bearing, static_cast<double>(i) * pitch_)) < half_width) return false;
  return true;
}

bool WhiskerContacts::nearest_free(double wanted, double half_width, double most, double& found) const {
  // Where walls are near on all sides, less room must do.
  double room = half_width;
  do {
    for (int step = 0; step * pitch_ <= most; ++step)
      for (const int side : {1, -1}) {
        found = wrap_angle(wanted + side * step * pitch_);
        if (free(found, room)) return true;
      }
    room *= 0.5;
  } while (room > 0.5 * pitch_);
  return false;
}

double WhiskerContacts::middle() const {
  Vec2 sum(0, 0);
  for (std::size_t i = 0; i < solid_.size(); ++i) {
    const SinCos t = sin_cos(static_cast<double>(i) * pitch_);
    if (solid_[i]) sum += Vec2(t.cos, t.sin);
  }
  return angle_of(sum.y(), sum.x());
}

namespace {

class WhiskerDrive {
 public:
  WhiskerDrive(const Platform& platform, const WhiskerDriveOptions& options)
      : options_(options), speed_(platform.body.v_max), contacts_(platform.whisker.count) {
    validate(options);
    check_whiskers(platform);
    if (platform.body.drive != DriveKind::omnidirectional)
      fail("navigator 'whiskers': robot '{}' is not omnidirectional", platform.name);
  }

  NavigatorStep step(const Observation& seen, const Subgoal& subgoal) {
    contacts_.update(seen, went_);
    went_.reset();
    const Vec2 way = inverse(seen.odometry.pose) * subgoal.position;
    const double distance = way.norm();
    if (distance <= subgoal.tolerance) {
      target_ = subgoal.position;
      nearest_ = distance;
      since_ = seen.time;
      return {{}, NavigatorStatus::arrived, {}};
    }
    if (no_progress(seen.time, distance, subgoal.position))
      return {{}, NavigatorStatus::trapped, "no way along what the whiskers touch"};
    double bearing = 0;
    if (!contacts_.nearest_free(angle_of(way.y(), way.x()), options_.half_width, options_.most_detour, bearing))
      return {{}, NavigatorStatus::driving, {}};
    const double speed = std::min(speed_, distance / seen.period);
    went_ = bearing;
    const SinCos t = sin_cos(bearing);
    return {{speed * t.cos, 0, speed * t.sin}, NavigatorStatus::driving, {}};
  }

  void reset() { *this = WhiskerDrive(*this, 0); }

 private:
  WhiskerDrive(const WhiskerDrive& other, int)
      : options_(other.options_), speed_(other.speed_), contacts_(static_cast<int>(other.contacts_.solid().size())) {}

  bool no_progress(double time, double distance, const Vec2& target) {
    if ((target - target_).norm() > options_.progress || distance < nearest_ - options_.progress) {
      if ((target - target_).norm() > options_.progress) target_ = target;
      nearest_ = distance;
      since_ = time;
    }
    return time - since_ > options_.patience;
  }

  WhiskerDriveOptions options_;
  double speed_;
  WhiskerContacts contacts_;
  std::optional<double> went_;  ///< bearing of the last command
  Vec2 target_{1e9, 1e9};
  double nearest_ = 0, since_ = 0;
};

}  // namespace

Navigator whisker_drive(const Platform& platform, const WhiskerDriveOptions& options) {
  const auto drive = std::make_shared<WhiskerDrive>(platform, options);
  return {.name = "whiskers",
          .step = [drive](const Observation& seen, const Subgoal& subgoal) { return drive->step(seen, subgoal); },
          .reset = [drive] { drive->reset(); },
          .body_radius = platform.body.radius};
}

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "indicator/sonar_profile.hpp"

namespace meander {

/// [DG] section 2, item 1, by the polar profile: from an indicator along a corridor, as long as the way leads on in one
/// direction, to where there is something to decide. One for one robot.
class ProfileWay {
 public:
  ProfileWay(const Platform& platform, const SonarProfileOptions& options = {});

  /// What there is at the place where the robot is.
  enum class Found { way, crossing, dead_end };

  /// The robot was set down.
  void begin();
  /// Takes in one scan.
  void hear(const Observation& observation);
  /// The way begins here.
  void leave(double direction);
  /// One cycle on the way.
  Found follow();

  /// Where to drive.
  const Vec2& aim() const { return aim_; }
  /// Since the way began [m].
  double walked() const { return walked_ - left_at_; }
  const Vec2& left() const { return left_; }
  /// Direction of the way that it came by, if it was not set down here.
  std::optional<double> back() const;
  /// The motion directions here, the one it came by among them.
  std::vector<SeenPort> openings();

 private:
  struct Step {
    Vec2 at{0, 0};
    double walked = 0;  ///< [m]
  };
  bool goes_round() const;
  Found along();
  Found at_anchor();
  void seek_anchor(double far);
  std::vector<SeenPort> ways_on();
  void drive_on(double direction, double way);

  SonarProfile profile_;
  std::deque<Step> trail_;        ///< the last half metre
  std::vector<Step> since_left_;  ///< places passed since the way began
  Vec2 at_{0, 0}, left_{0, 0}, aim_{0, 0};
  double course_ = 0;                                ///< [rad]
  double walked_ = 0, left_at_ = 0, looked_at_ = 0;  ///< [m]
  double quiet_until_ = 0;                           ///< crossings count from here on [m]
  int crossings_ = 0, dead_ends_ = 0;                ///< seen in a row
  int waited_ = 0, listened_ = 0, anchors_ = 0;
  bool to_anchor_ = false;
};

}  // namespace meander

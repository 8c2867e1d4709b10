// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

struct SonarMemoryOptions {
  int scans = 10;
  double range_min = 0.152;
  double range_max = 6.477;
  double saturated_gap = 0.04;
  int contradictions = 2;
  double contradiction_angle = 0.1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarMemoryOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"scans", "", "how many scans are remembered", 1, 1000}, o.scans);
  visit(Field{"range_min", "m", "least range of the sonars: what reads so near may touch the hull", 0, 10},
        o.range_min);
  visit(Field{"range_max", "m", "a reading from here on is no echo", 0.1, 1000}, o.range_max);
  visit(Field{"saturated_gap", "m", "a reading at the least range counts as a point this far from the hull", 0, 1},
        o.saturated_gap);
  visit(Field{"contradictions", "", "newer beams through a point that make it forgotten; 0: never", 0, 1000},
        o.contradictions);
  visit(Field{"contradiction_angle", "rad", "how far off a beam's axis its range still tells that a place is free", 0,
              1.5},
        o.contradiction_angle);
}

/// Where a sonar return lies, in the odometry frame.
struct MemoryPoint {
  Vec2 position{0, 0};
  int contradicted = 0;  ///< newer beams that went through it
};

/// The short-term memory [LM99]: the last few scans in a ring buffer, as points on the beams' axes in the odometry
/// frame, each taken from where the robot was when that sonar fired.
class SonarMemory {
 public:
  SonarMemory(const Platform& platform, const SonarMemoryOptions& options);

  /// The oldest scan makes room for this one, whose beams may contradict what is remembered.
  void remember(const Readings& readings);
  void clear();

  struct Beam {
    Vec2 from{0, 0};
    Vec2 axis{0, 0};
    double reading = 0;
  };
  /// The newest scan as it was read, in the odometry frame.
  std::span<const Beam> beams() const { return beams_; }
  /// Scans there are, 0 the newest.
  int scans() const { return held_; }
  std::span<const MemoryPoint> scan(int age) const;

 private:
  struct Scan {
    std::vector<MemoryPoint> points;
    std::size_t count = 0;
  };
  void aim(const Readings& readings);
  void contradict();
  bool passes_through(const Beam& beam, const Vec2& point) const;
  void take_points(double silence);

  RingLayout layout_;
  double body_radius_;
  SonarMemoryOptions options_;
  double axis_cosine_;
  std::vector<Scan> ring_;
  std::vector<Beam> beams_;  ///< of the newest scan
  int newest_ = 0;
  int held_ = 0;
};

}  // namespace meander

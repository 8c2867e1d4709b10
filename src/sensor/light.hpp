// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "base/fields.hpp"
#include "base/random.hpp"
#include "robot/platform.hpp"
#include "sensor/scene.hpp"

namespace meander {

/// Passive light sensors: each looks outwards through a wide lobe.
struct LightSensorOptions {
  double lobe = 0.4363323129985824;  ///< standard deviation of the Gaussian lobe [rad]
  double contrast = 100;             ///< the reading is ln(1 + contrast b) / ln(1 + contrast) for brightness b
  double noise = 0.03;               ///< of the gain, as a share of the reading
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LightSensorOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"lobe", "rad", "standard deviation of the lobe", 0.01, 10}, o.lobe);
  visit(Field{"contrast", "", "how strongly the logarithm compresses the brightness", 1e-3, 1e9}, o.contrast);
  visit(Field{"noise", "", "standard deviation of the gain, as a share of the reading", 0, 1}, o.noise);
}

/// Copying it forks it.
class LightRing {
 public:
  LightRing(const RingLayout& layout, const LightSensorOptions& options, std::uint64_t seed);
  /// Compressed brightness in ring order; `readings` has layout.count entries. A lamp of strength s gives s/(1 + d^2)
  /// at d metres, times the lobe; walls, poles and moving discs but that of owner `self` throw shadows.
  void read(const Scene& scene, const Pose2& pose_world, std::uint32_t self, std::span<double> readings);
  void add_to(Hash& hash) const { stream_.add_to(hash); }

 private:
  double brightness(const Scene& scene, const Vec2& place, double bearing, std::uint32_t self) const;

  RingLayout layout_;
  LightSensorOptions options_;
  double full_scale_;  ///< ln(1 + contrast)
  Stream stream_;
};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "robot/observation.hpp"
#include "topology/correlation.hpp"

namespace meander::topology {

struct TopologicMapOptions {
  Scales scales;
  NetOptions net;
  CorrelationOptions correlation;
  double touch_smoothing = 0.3490658503988659;  ///< standard deviation [rad]
  int presentations = 4;                        ///< k: how often a situation is shown
  int delay = 10;                               ///< l: samples until it is shown
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TopologicMapOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"scales", "", "one unit of distance between situations"}, o.scales);
  visit(Field{"net", "", "how the net grows and adapts"}, o.net);
  visit(Field{"correlation", "", "how the map corrects the believed pose"}, o.correlation);
  visit(Field{"touch_smoothing", "rad", "standard deviation of the smoothing of contacts along the ring", 0.01, 3},
        o.touch_smoothing);
  visit(Field{"presentations", "", "how often a situation is shown to the net", 1, 100}, o.presentations);
  visit(Field{"delay", "", "samples until a situation is shown", 0, 10000}, o.delay);
}

/// What the net made of a sample.
struct Recognition {
  std::int64_t sample = -1;  ///< the situation that was shown; `delay` samples ago
  int cell = -1;             ///< its place in the map
  double distance = 0;
};

/// The qualitative topologic map (QT-map) of [Z]: places with what was sensed there, linked where the robot went from
/// one to the other, learnt from whiskers, light sensors and bad dead reckoning alone.
class TopologicMap {
 public:
  /// `whiskers` and `lights` are the sizes of the rings.
  TopologicMap(const TopologicMapOptions& options, int whiskers, int lights);

  /// One sample. Throws ArgumentError when its rings have other sizes.
  void step(const Observation& observation);

  const TopologicMapOptions& options() const { return options_; }
  const GrowingNet& net() const { return net_; }
  GrowingNet& net() { return net_; }
  int whiskers() const { return metric_.touch(); }
  int lights() const { return metric_.light(); }
  /// Samples so far.
  std::int64_t samples() const { return samples_; }
  /// Where the robot believes to be, in the map's frame: the odometry frame of the first sample, but for the errors.
  const Pose2& pose() const { return pose_; }
  /// map_from_odometry now: turns places of the odometry frame into places of the map.
  Pose2 map_from_odometry() const { return pose_ * inverse(odometry_); }
  /// Of the last presentation.
  const Recognition& recognition() const { return recognition_; }
  /// What the correlation said last.
  const Correction& correction() const { return correction_; }
  /// The robot's own senses of now, in its own frame.
  SenseRings rings() const { return {touch_, light_}; }

 private:
  friend struct MapState;
  struct Waiting {
    Vec2 position;
    std::vector<float> senses;
  };
  void dead_reckon(const Pose2& odometry);
  void sense(const Readings& readings);
  void correlate();
  void remember();
  void learn();
  Waiting& waiting(std::int64_t sample) {
    return queue_[static_cast<std::size_t>(sample % static_cast<std::int64_t>(queue_.size()))];
  }

  TopologicMapOptions options_;
  SenseMetric metric_;
  TouchSmoother smoother_;
  GrowingNet net_;
  Correlation correlation_;
  std::vector<Waiting> queue_;  ///< the last delay + 1 situations, a ring
  std::vector<float> touch_, light_;
  std::int64_t samples_ = 0;
  Pose2 odometry_, pose_;
  Recognition recognition_;
  Correction correction_;
};

}  // namespace meander::topology

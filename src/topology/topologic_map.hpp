// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "robot/observation.hpp"
#include "robot/platform.hpp"
#include "topology/correlation.hpp"
#include "topology/link_doubt.hpp"

namespace meander::topology {

struct TopologicMapOptions {
  Scales scales;
  NetOptions net;
  CorrelationOptions correlation;
  DoubtOptions doubt;
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
  visit(Field{"doubt", "", "how contacts suspend links"}, o.doubt);
  visit(Field{"touch_smoothing", "rad", "standard deviation of the smoothing of contacts along the ring", 0.01, 3},
        o.touch_smoothing);
  visit(Field{"presentations", "", "how often a situation is shown to the net", 1, 100}, o.presentations);
  visit(Field{"delay", "", "samples until a situation is shown", 0, 10000}, o.delay);
}

/// The sensors that a map is built from.
struct SenseSuite {
  int whiskers = 24;
  int lights = 24;
  double whisker_radius = 0.15;  ///< of the ring of their roots [m]
  double whisker_reach = 0.15;   ///< beyond it [m]
};

/// Throws ArgumentError for a robot without whiskers, or whose first one is not ahead: bearings are counted from there.
void check_whiskers(const Platform& robot);
/// Of a robot whose whiskers reach so far beyond their roots. Throws ArgumentError as check_whiskers does; for lights
/// too.
SenseSuite sense_suite(const Platform& robot, double whisker_reach);

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
  /// For a robot with these whiskers and light sensors. Throws ArgumentError for options out of range, or a robot
  /// without whiskers.
  TopologicMap(const TopologicMapOptions& options, const SenseSuite& suite);

  /// One sample. Throws ArgumentError when its rings have other sizes; the map then stays as it was.
  void step(const Observation& observation);
  /// One sample that is not learnt: the robot only stays localised and links are judged. Throws as step does.
  void follow(const Observation& observation);
  /// A new run begins: what comes next does not follow from the last sample, and its odometry begins anew. `pose`:
  /// where the robot is now, in the map's frame; without it where it was last. Throws ArgumentError for what is
  /// nowhere.
  void begin(const std::optional<Pose2>& pose = {});
  /// The believed position is wrong by this much [m]; so are those of the samples that wait, which are not learnt.
  void shift(const Vec2& by);

  const TopologicMapOptions& options() const { return options_; }
  const GrowingNet& net() const { return net_; }
  GrowingNet& net() { return net_; }
  const SenseSuite& suite() const { return suite_; }
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
  /// What the correlation said last; its cell is in the map.
  const Correction& correction() const { return correction_; }
  /// What is sensed now, in the frame of the map.
  Situation situation() const { return {pose_.position(), now_.data()}; }
  /// The same in the robot's own frame.
  SenseRings rings() const { return {touch_, light_}; }

 private:
  friend struct MapState;
  struct Waiting {
    Vec2 position;
    std::vector<float> senses;
  };
  void break_off();
  void check_rings(const Readings& readings) const;
  void localise(const Observation& observation);
  void dead_reckon(const Pose2& odometry);
  void sense(const Readings& readings);
  void correlate();
  void remember();
  void learn();
  std::uint64_t serial_of(int cell) const { return cell < 0 ? 0 : net_.cells()[cell].serial; }
  Waiting& waiting(std::int64_t sample) {
    return queue_[static_cast<std::size_t>(sample % static_cast<std::int64_t>(queue_.size()))];
  }

  TopologicMapOptions options_;
  SenseSuite suite_;
  SenseMetric metric_;
  TouchSmoother smoother_;
  GrowingNet net_;
  Correlation correlation_;
  LinkDoubt doubt_;
  std::vector<Waiting> queue_;  ///< the last delay + 1 situations, a ring
  std::vector<float> touch_, light_;
  std::vector<float> now_;  ///< both in the frame of the map
  std::int64_t samples_ = 0;
  std::int64_t learnt_from_ = 0;  ///< samples before this are not shown any more
  bool learning_ = true;
  bool begins_ = false;  ///< the next sample is the first of a run: its odometry says nothing of the last
  Pose2 odometry_, pose_;
  Recognition recognition_;
  Correction correction_;
};

}  // namespace meander::topology

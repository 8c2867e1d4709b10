// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "base/fields.hpp"
#include "indicator/explorer.hpp"
#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

struct SonarProfileOptions {
  double memory = 2;
  double range = 3;
  double through = 0.06;
  double beam = 0.11;
  int directions = 72;
  double slim = 0.08;
  double open = 0.8;
  double least = 0.17;
  double most = 1.3;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarProfileOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"memory", "m", "echoes are kept for so much way", 0.1, 100}, o.memory);
  visit(Field{"range", "m", "what is farther away counts for nothing", 0.1, 100}, o.range);
  visit(Field{"through", "m", "an echo is forgotten when a later beam through it reads so much more", 0, 10},
        o.through);
  visit(Field{"beam", "rad", "half opening angle within which a beam goes through an echo", 0, 1.4}, o.beam);
  visit(Field{"directions", "", "in so many directions it is asked how far the robot could drive", 8, 3600},
        o.directions);
  visit(Field{"slim", "m", "the robot is taken to be narrower by so much: cones show walls nearer to their axis", 0, 1},
        o.slim);
  visit(Field{"open", "m", "a direction is open when the robot could drive so far, or, in wide places, farther", 0.1,
              100},
        o.open);
  visit(Field{"least", "rad", "a narrower interval of open directions is none", 0, 3}, o.least);
  visit(Field{"most", "rad", "a wider interval is cut", 0.1, 7}, o.most);
}

/// The polar profile of one place: how far the robot could drive from here in each direction, by the echoes of its last
/// metres of way; and the motion intervals in it ([DG] Figure 1).
class SonarProfile {
 public:
  SonarProfile(const Platform& platform, const SonarProfileOptions& options = {});

  /// Takes in one scan.
  void update(const Observation& observation);
  void clear();

  /// Middles of the motion intervals at a place, and how far it is open there.
  std::vector<SeenPort> openings(const Vec2& at);
  /// How far the robot could drive from a place, at most `range` [m].
  double way_on(const Vec2& at, double direction) const;
  /// To the nearest echo, at most `range` [m].
  double clearance(const Vec2& at) const;

 private:
  struct Echo {
    Vec2 at{0, 0};
    double walked = 0;  ///< the way of the robot when it was heard [m]
  };
  /// Directions `first` to `first + count - 1` of the profile, which is closed in itself.
  struct Interval {
    int first = 0, count = 0;
  };
  void look(const Vec2& at);
  double length(int direction) const;
  void divide(const Interval& interval, std::vector<Interval>& pieces);

  SonarProfileOptions options_;
  RingLayout ring_;
  double radius_;   ///< of the disc that drives
  double tangent_;  ///< of half a beam
  std::deque<Echo> echoes_;
  std::vector<double> lengths_;  ///< by direction [m]
  std::vector<double> rest_;     ///< of an interval that is divided [m]
  double walked_ = 0;
  std::optional<Vec2> last_;
};

}  // namespace meander

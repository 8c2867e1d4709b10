// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>

#include "polar/polar_solver.hpp"

namespace meander {

struct SubgoalReadoutOptions {
  double read_radius = 0.2;
  double hysteresis = 0.5;
  double hysteresis_ratio = 20;
  int hysteresis_sectors = 4;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SubgoalReadoutOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"read_radius", "m", "the direction is that of the most active unit this far from the centre", 0, 100},
        o.read_radius);
  visit(
      Field{"hysteresis", "m", "another direction wins only if its way is so much shorter; finite volumes only", 0, 10},
      o.hysteresis);
  visit(Field{"hysteresis_ratio", "", "the same for other weights: only if its activation is so many times higher", 1,
              1e9},
        o.hysteresis_ratio);
  visit(Field{"hysteresis_sectors", "", "directions so few sectors apart are not another direction", 0, 128},
        o.hysteresis_sectors);
}

/// Where to go now, in the frame of the map.
struct PolarSubgoal {
  int sector = 0;
  int ring = 0;
  Vec2 position{0, 0};
  bool exact = false;  ///< the target itself rather than the unit nearest to it
};

/// A polar map at rest, as rules see it.
struct PolarState {
  const PolarLayout& layout;
  const PolarSolver& solver;
  Vec2 target{0, 0};            ///< in the frame of the map: on its x axis
  int target_ring = 0;          ///< of the target unit, in sector 0
  std::optional<int> previous;  ///< sector of the direction chosen last
};

/// A rule of one's own; none: nothing reaches the robot.
using OwnSubgoal = std::function<std::optional<PolarSubgoal>(const PolarState&)>;

/// The ring of the target unit: the outermost when it lies beyond the scope, else the nearest that is neither the inner
/// nor the outer one.
int target_ring(const PolarLayout& layout, double distance);

/// Reads the subgoal off: direction, then steepest ascent along it [LM99]. Nothing when no activation arrives.
class SubgoalReadout {
 public:
  /// `kappa` [1/m]: how fast ln v falls along a way; 0 where activation does not tell ways.
  SubgoalReadout(const SubgoalReadoutOptions& options, double kappa);
  std::optional<PolarSubgoal> operator()(const PolarState& state) const;

 private:
  int direction(const PolarState& state, int ring) const;
  SubgoalReadoutOptions options_;
  double advantage_;  ///< activation of a way shorter by the hysteresis
};

}  // namespace meander

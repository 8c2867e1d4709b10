// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "polar/point_mapper.hpp"

namespace meander {

struct LayoutOrganiserOptions {
  double share = 0.5;
  double rate = 0.02;
  double step = 0.25;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LayoutOrganiserOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"share", "", "of the units that follow the readings; the others stay where a fixed layout has them", 0,
              0.9},
        o.share);
  visit(Field{"rate", "1/cycle", "how fast older readings are forgotten", 1e-4, 1}, o.rate);
  visit(
      Field{"step", "",
            "the layout moves when a ring or sector is off its place by so much of the distance to the next", 0.01, 10},
      o.step);
}

/// [LM99+] The self-organising map that [LM99] names as future work: rings and sectors lie dense where readings are.
/// How many readings fall between two neighbours of the fixed layout is learnt cycle by cycle; the new places are the
/// quantiles of a mixture of these shares and of equal ones. So two neighbours are at most 1 / (1 - share) times as far
/// apart as in the fixed layout there, and not much nearer than a quarter; ring 0 stays at the centre, the last at the
/// scope, and sector 0 at the target.
class LayoutOrganiser {
 public:
  LayoutOrganiser(const PolarLayoutOptions& layout, const LayoutOrganiserOptions& options);

  void reset();
  /// Learns from what is mapped.
  void learn(std::span<const MappedPoint> points);
  /// Moves the layout, if it is off by enough to be worth it. Allocates nothing.
  bool organise(PolarLayout& layout);
  /// The layout that they started from.
  const PolarLayout& fixed() const { return fixed_; }

 private:
  /// Numbers along one axis: where a fixed layout has its units, how often readings fell between, and where they are
  /// better.
  struct Axis {
    std::vector<double> fixed, hits, wanted, placed;
  };
  void forget(Axis& axis) const;
  void place(Axis& axis) const;
  bool off(const Axis& axis) const;

  LayoutOrganiserOptions options_;
  PolarLayout fixed_;
  Axis radii_, bearings_;
};

}  // namespace meander

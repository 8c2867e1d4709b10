// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "base/text_lines.hpp"
#include "indicator/sonar_occupancy.hpp"

namespace meander {

/// [DG+] Where a robot did not get on, a wall is drawn across its way, so that it goes elsewhere. It was not measured:
/// what was known before is kept, for it has to be taken back before a goal is given up. One for one map.
class TriedInVain {
 public:
  /// A run begins: what was drawn stays.
  void begin() { stops_.clear(); }
  /// Draws where the front is of a robot that stands at `at` and did not get on to `ahead`. Where it is stopped twice
  /// in a run, what its sonars tell is not to be believed.
  void stop(SonarOccupancy& map, const Vec2& at, const Vec2& ahead);
  /// All is again as if nothing had been drawn. False: nothing was.
  bool take_back(SonarOccupancy& map);

  /// What was drawn as lines "tried X Y EVIDENCE": a cell's centre, and what was known before; then "done".
  std::string lines() const;
  void read(TextLines& lines);

 private:
  /// A cell that was drawn.
  struct Drawn {
    Vec2 place{0, 0};
    double before = 0;  ///< evidence
  };
  std::vector<Vec2> stops_;  ///< where it was stopped in this run
  std::vector<Drawn> drawn_;
};

}  // namespace meander

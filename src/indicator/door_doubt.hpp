// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/text_lines.hpp"
#include "indicator/sonar_occupancy.hpp"

namespace meander {

/// [DG+] A wall where it was free in an earlier run is a door, and may be open again: from time to time nothing is
/// known of it any more, so that whoever would profit by a way there goes and looks. One for one map.
class DoorDoubt {
 public:
  /// A run begins: doors are doubted each `recheck`-th time (0: never), and what is free now is remembered.
  void begin(SonarOccupancy& map, int run, int recheck);

  /// What it remembers as lines "once X Y CELLS": column and row of the first, how many to the right; then "done".
  std::string lines() const;
  void read(TextLines& lines, const SonarOccupancy& map);

 private:
  void fit(const SonarOccupancy& map);

  Grid<std::uint8_t> once_;  ///< 1: free in an earlier run
};

}  // namespace meander

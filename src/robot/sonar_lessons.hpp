// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "robot/cell_truth.hpp"
#include "robot/platform.hpp"

namespace meander {

/// Scans with cells around the robot whose truth is known: what sensor models learn from and are measured by.
struct SonarLessons {
  struct Cell {
    std::uint32_t scan = 0;
    float range = 0;    ///< from the robot's centre [m]
    float bearing = 0;  ///< from its heading [rad]
    CellTruth truth = CellTruth::hidden;
  };
  RingLayout ring;
  double range_max = 6.477;    ///< this and more: no echo [m]
  std::vector<double> ranges;  ///< scan by scan, in ring order [m]
  std::vector<Cell> cells;     ///< scan by scan

  std::span<const double> scan(std::uint32_t index) const {
    const auto count = static_cast<std::size_t>(ring.count);
    return std::span(ranges).subspan(index * count, count);
  }
  std::size_t scans() const { return ring.count > 0 ? ranges.size() / static_cast<std::size_t>(ring.count) : 0; }
};

}  // namespace meander

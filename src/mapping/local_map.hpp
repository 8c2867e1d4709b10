// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "grid/grid.hpp"
#include "mapping/fusion.hpp"
#include "mapping/sonar_model.hpp"
#include "mapping/sweep.hpp"
#include "mapping/view_memory.hpp"
#include "robot/observation.hpp"

namespace meander {

struct LocalMapOptions {
  int size = 60;
  double resolution = 0.05;
  double range_max = 6.477;
  FusionOptions fusion;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LocalMapOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"size", "", "cells along a side of the local map", 2, 400}, o.size);
  visit(Field{"resolution", "m", "side of a cell", 0.01, 1}, o.resolution);
  visit(Field{"range_max", "m", "a reading from here on is no echo", 0.1, 1000}, o.range_max);
  fields(o.fusion, visit);
}

/// The local grid map of [CN]: a square window of cells that slides with the robot, fixed in the frame of the odometry
/// as far as cells go, so that turning costs nothing and nothing is ever resampled. Cells hold log-odds; 0: unknown.
class LocalMap {
 public:
  /// The model must be for the platform's ring, which has sonars. `feeds`: a map of everywhere takes the increments, so
  /// that what views said of places is kept when these leave the window. Throws ArgumentError.
  LocalMap(const Platform& platform, SonarModel model, const LocalMapOptions& options = {}, bool feeds = false);

  /// Takes in one scan. Throws ArgumentError when the readings are not those of the ring or the pose is no place, Error
  /// when no more can be kept, and whatever the model throws; the map stays as it was then.
  void step(const Observation& observation);
  void clear();

  /// ln(P / (1 - P)) of the cell of the odometry frame: cell (0, 0) has its lower left corner at the origin. 0 outside
  /// the window.
  float log_odds(Cell cell) const { return covers(cell) ? cells_[slot(cell)] : 0; }
  bool covers(Cell cell) const {
    return cell.x >= low_.x && cell.y >= low_.y && cell.x < low_.x + options_.size && cell.y < low_.y + options_.size;
  }
  Cell cell(const Vec2& point) const { return frame().cell(point); }
  Vec2 center(Cell cell) const { return frame().center(cell); }
  /// Lower left cell of the window around a robot. Throws ArgumentError when the pose is no place.
  Cell low_around(const Pose2& robot) const;
  /// Lower left cell of the window.
  Cell low() const { return low_; }
  const LocalMapOptions& options() const { return options_; }
  const SonarModel& model() const { return model_; }
  /// What the last scan added to the evidence, row by row from low(): to be added wherever evidence is kept as well.
  std::span<const float> increments() const { return everywhere_.empty() ? increments_ : everywhere_; }
  /// The largest |log-odds| of a cell.
  float limit() const { return limit_; }
  /// The window, bottom row first, placed in the odometry frame.
  Grid<float> log_odds() const;
  std::size_t bytes() const;

 private:
  void slide(Cell to);
  void replace(Cell left, Cell entered);
  void place_cells(Cell low, const Pose2& pose);
  void weigh(double heading);
  void update();
  GridFrame frame() const { return {options_.resolution, {}}; }
  std::size_t slot(Cell cell) const;

  LocalMapOptions options_;
  SonarModel model_;
  float limit_;
  float body_radius_;
  SweepMaker sweeps_;
  ViewMemory views_;
  Cell low_;
  std::vector<float> range_;       ///< R of [CN] Figure 3, row by row from low_ [m]
  std::vector<float> bearing_;     ///< theta [rad]
  std::vector<float> told_;        ///< by the last scan: ln(P(c|o) / (1 - P(c|o))), row by row from low_
  std::vector<float> increments_;  ///< the same, less what was known since the cell is in the window
  std::vector<float> everywhere_;  ///< the same, less what was ever known, where the map feeds another
  std::vector<float> cells_;       ///< ring buffer in both directions: cell (x, y) at (x mod size, y mod size)
};

}  // namespace meander

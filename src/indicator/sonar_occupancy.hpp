// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"
#include "indicator/configuration_space.hpp"
#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

struct SonarOccupancyOptions {
  double resolution = 0.05;
  double half_cone = 0.2181661564992912;
  double range = 3;
  double arcs = 1.3;
  double silent = 6.4;
  double silence = 3;
  double moved = 0.045;
  double margin = 0.025;
  double hard = 6;
  double suspect = 0.6;
  double room = 0.225;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarOccupancyOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"resolution", "m", "side of a cell", 0.01, 1}, o.resolution);
  visit(Field{"half_cone", "rad", "half opening angle of a sonar's cone", 0.01, 1}, o.half_cone);
  visit(Field{"range", "m", "what is farther away counts for nothing", 0.1, 100}, o.range);
  visit(Field{"arcs", "m", "echoes from farther away are no walls", 0, 100}, o.arcs);
  visit(Field{"silent", "m", "a reading from here on is no echo", 0.1, 1000}, o.silent);
  visit(Field{"silence", "m", "where nothing echoes it is free so far", 0, 100}, o.silence);
  visit(Field{"moved", "m", "a scan counts when the robot has moved so far since the last", 0, 10}, o.moved);
  visit(Field{"margin", "m", "kept from walls beside the robot's radius", 0, 1}, o.margin);
  visit(Field{"hard", "", "a wall with more evidence than this is certain, and hardly worn away", 2.6, 29}, o.hard);
  visit(Field{"suspect", "", "with more evidence than this a wall is suspected, and nothing expected behind", 0, 2.5},
        o.suspect);
  visit(Field{"room", "m", "ways leave so much more beside them, where they can", 0, 10}, o.room);
}

/// What sonars have told of all places so far, and where the robot's centre can be by that. Everything inside a cone up
/// to shortly before the reading is free; where the echo came from on the arc is not known, so that the arc counts as
/// wall only near by, and only after a move, for readings at one place err alike. Grows with where the robot goes.
class SonarOccupancy {
 public:
  SonarOccupancy(const Platform& platform, const SonarOccupancyOptions& options = {});

  /// Takes in one scan, and what the bumpers feel.
  void update(const Observation& observation);
  /// Makes room around a point. Frames that change make positions of cells, and all that hangs on them, stale. Throws
  /// Error where that takes more than kMostCells.
  void include(const Vec2& point);
  /// As many cells the map has with room around a point.
  double cells_with(const Vec2& point) const;
  static constexpr double kMostCells = 16e6;
  int frames() const { return frames_; }
  int scans() const { return scans_; }

  const ConfigurationSpace& space() const { return space_; }
  /// Evidence for a wall at the cell: above 2.5 it counts as one, below -2.5 as free.
  double evidence(Cell cell) const { return evidence_.at(cell, 0); }
  /// A wall for which too little speaks to give a goal up.
  bool weak(Cell cell) const { return space_.known(cell) == Known::wall && evidence(cell) <= options_.hard; }
  /// Adds evidence for a wall: for what was felt.
  void add(Cell cell, double evidence);
  /// From now on there is at least so much evidence for a wall: where it was tried in vain.
  void raise(Cell cell, double evidence);
  /// Nothing is known of the cell any more.
  void forget(Cell cell);
  /// The same with what is weak taken away.
  ConfigurationSpace without_weak() const;
  double reach() const { return reach_; }

  /// All that it remembers, for files.
  struct Memory {
    Vec2 low{0, 0}, high{0, 0};  ///< its room [m]
    Vec2 last{0, 0};             ///< where the robot was at the last scan that counted [m]
    double last_heading = 0;     ///< [rad]
    int scans = 0;
    Grid<float> evidence;
  };
  Memory memory() const;
  void restore(const Memory& memory);
  /// An empty grid for a room; its lower corner lies on a corner of a cell.
  Grid<float> empty_room(const Vec2& low, const Vec2& high) const;

 private:
  struct Cone {
    Vec2 at{0, 0}, axis{1, 0};
    double reading = 0;
  };
  bool has_room(const Vec2& point) const;
  std::pair<Vec2, Vec2> room_with(const Vec2& point) const;
  void make_room(Grid<float> room, Grid<float> known);
  void listen(const Observation& observation);
  void stand(const Vec2& at);
  void feel(const Observation& observation);
  void take_free(const Cone& cone);
  void take_arc(const Cone& cone);
  template <class Visit>
  void for_cells(const Cone& cone, double reach, Visit visit);

  SonarOccupancyOptions options_;
  RingLayout ring_, bumper_;
  double radius_, reach_, tangent_;
  double aperture_;  ///< cones begin so wide to either side, that there is no gap between them [m]
  ConfigurationSpace space_;
  Grid<float> evidence_;
  Grid<std::int32_t> freed_;  ///< in which scan the cell was found free last
  Vec2 low_{0, 0}, high_{0, 0};
  Vec2 last_{0, 0};
  double last_heading_ = 0;
  std::vector<Cone> cones_;
  int scans_ = 0, frames_ = 0;
};

}  // namespace meander

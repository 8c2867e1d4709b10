// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "sensor/sonar_wedge.hpp"

namespace meander::sonar {

/// Directions s from `low` to `high`.
struct Interval {
  double low, high;
};

/// The directions in which a thing is hidden. The vector keeps its memory from use to use.
class Shadows {
 public:
  Shadows() { intervals_.reserve(64); }
  /// In which directions do the pieces whose nearest point is within `most` hide the target?
  void cast(const Piece& target, std::span<const Piece> pieces, double most);

  /// Disjoint, in rising order. Gaps below 2e-10 are closed: walls that meet at a point rounded differently are tight.
  std::span<const Interval> intervals() const { return intervals_; }

 private:
  void merge();
  void add(double low, double high);
  void add_below(const Piece& target, const Piece& wall);
  void add_within(const Piece& target, const Piece& disc);
  void add_before_disc(const Piece& target, const Piece& other);

  std::vector<Interval> intervals_;
  std::vector<double> breaks_;
};

/// Is the point (s, w) behind a piece?
bool hides(const Piece& piece, double s, double w);

/// Moves the echo to its nearest point that is not hidden (its range to kNever if there is none), given that all pieces
/// nearer than `reach` are known. Beyond `reach` the range stays a lower bound, to be settled again when more is known.
void settle(Echo& echo, std::span<const Piece> pieces, double reach, Shadows& shadows);

}  // namespace meander::sonar

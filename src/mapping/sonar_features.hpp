// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "mapping/network.hpp"
#include "mapping/sonar_model.hpp"

namespace meander {

/// What a network is told about a cell: the readings of the sonars that point nearest its way, nearest first, and where
/// it is, [CN] 2.1 and 3.2.
struct SonarFeatures {
  int sonars = 2;               ///< 2 or 3
  bool bearing = false;         ///< the angle between the cell and the axis of the nearest sonar, too
  bool residual = false;        ///< of each of these readings also whether it ends before or behind the cell
  double range_cap = 2.6;       ///< longer readings are taken for this, from the robot's centre [m]
  double reach = 2.2;           ///< cells farther from the robot's centre are left alone [m]
  double residual_scale = 0.2;  ///< [m]

  int inputs() const { return sonars + 1 + (bearing ? 1 : 0) + (residual ? sonars : 0); }
  bool operator==(const SonarFeatures&) const = default;
};

/// Throws ArgumentError.
void check_features(const SonarFeatures& features);

/// By name: nn1, nn2, nn3 of [CN] Fig. 2; nn4, both of what nn2 and nn3 add; nn5, nn4 with residuals. Throws
/// ArgumentError that lists them.
SonarFeatures sonar_features(const std::string& network);
std::vector<std::string> sonar_network_names();

namespace mapping {

/// The readings and the place behind the features of a few cells.
struct Selection {
  Lanes nearest, second, third;  ///< readings from the robot's centre, capped [m]
  Lanes range;                   ///< of the cell, at most the reach [m]
  Lanes offset;                  ///< of the cell from the nearest sonar's axis, in pitches of the ring: 0 to 0.5
};

/// Picks readings for cells of one scan after the other.
class SonarSelector {
 public:
  SonarSelector(const RingLayout& ring, const SonarFeatures& features);

  /// The scan that select() reads from now on. Throws ArgumentError when it is not one of this ring.
  void take(const SonarSweep& sweep);
  [[gnu::always_inline]] Selection select(Lanes range, Lanes bearing) const;
  /// Features of four cells, into part `part` of the inputs.
  [[gnu::always_inline]] void fill(const Selection& cells, std::span<Block> inputs, std::size_t part) const;

  const SonarFeatures& features() const { return features_; }
  /// Cells farther away were out of the scan's hearing: it tells nothing of them [m].
  float reach() const { return reach_; }

 private:
  using Whole = std::int32_t __attribute__((vector_size(16)));
  static constexpr int kTurns = 4;  ///< bearings are within so many turns of 0

  RingLayout ring_;
  SonarFeatures features_;
  float reach_ = 0;
  float per_pitch_;              ///< 1 / angle between neighbours [1/rad]
  std::vector<float> readings_;  ///< capped, 2 kTurns times around the ring, one more at either end
};

inline Selection SonarSelector::select(Lanes range, Lanes bearing) const {
  const auto turns = static_cast<float>(kTurns * ring_.count);
  const Lanes u = (bearing - static_cast<float>(ring_.first)) * per_pitch_;
  const Lanes from_start = most(least(u + turns, all(2 * turns - 1)), all(0.0F));
  const Whole nearest = __builtin_convertvector(from_start + 0.5F, Whole);  // [CN] 3.2
  const Lanes offset = from_start - __builtin_convertvector(nearest, Lanes);
  const auto reach = static_cast<float>(features_.reach);
  Selection cells{{}, {}, {}, most(least(range, all(reach)), all(0.0F)), magnitude(offset)};
  for (int i = 0; i < kLanes; ++i) {
    const float* reading = readings_.data() + 1 + nearest[i];
    const std::ptrdiff_t side = offset[i] < 0.0F ? -1 : 1;
    cells.nearest[i] = reading[0];
    cells.second[i] = reading[side];
    cells.third[i] = reading[-side];
  }
  return cells;
}

inline void SonarSelector::fill(const Selection& cells, std::span<Block> inputs, std::size_t part) const {
  const auto by_cap = static_cast<float>(2 / features_.range_cap), by_reach = static_cast<float>(2 / features_.reach);
  const auto by_scale = static_cast<float>(1 / features_.residual_scale);
  std::size_t next = 0;
  const auto put = [&](Lanes value) { inputs[next++][part] = value; };
  const Lanes readings[] = {cells.nearest, cells.second, cells.third};
  for (int i = 0; i < features_.sonars; ++i) put(readings[i] * by_cap - 1.0F);
  put(cells.range * by_reach - 1.0F);
  if (features_.bearing) put(4.0F * cells.offset - 1.0F);
  // [CN+] The network need not learn the difference of two inputs.
  if (features_.residual)
    for (int i = 0; i < features_.sonars; ++i) put(tanh((readings[i] - cells.range) * by_scale));
}

}  // namespace mapping
}  // namespace meander

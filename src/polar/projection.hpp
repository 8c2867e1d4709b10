// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "polar/polar_layout.hpp"

namespace meander {

/// Which units of a polar map are obstructed: those whose receptive field, a circle around the unit, contains a point
/// [LM99]. One bit per unit, ring after ring within a sector. The innermost and the outermost ring never are.
class ObstructedUnits {
 public:
  explicit ObstructedUnits(const PolarLayout& layout);

  void clear();
  /// Bits of the rings first .. last of a sector.
  void obstruct(int sector, int first, int last);
  bool test(int ring, int sector) const {
    return sector_bits(sector)[static_cast<std::size_t>(ring) >> 6] >> (ring & 63) & 1;
  }
  /// The bits of a sector, 64 rings to a word.
  std::span<const std::uint64_t> sector_bits(int sector) const {
    return {bits_.data() + static_cast<std::size_t>(sector) * words_, words_};
  }
  bool operator==(const ObstructedUnits&) const = default;

 private:
  int rings_;
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

/// One layer of obstructed units per radius of the receptive field, filled in one go.
class Projection {
 public:
  Projection(const PolarLayout& layout, std::vector<double> radii);

  void clear();
  /// Obstructs, on each layer, all units within the layer's radius of the point. The radius is cut to 1 mm less than
  /// the point's distance: the robot stands at the centre, so nothing can be there.
  void add(const Vec2& point);
  /// A layer is wanted only this far from the centre: points that obstruct nothing there may be left out.
  void set_reach(std::size_t layer, double reach) { reaches_[layer] = reach; }
  const ObstructedUnits& layer(std::size_t index) const { return layers_[index]; }
  static constexpr double kCentreFree = 1e-3;

 private:
  void add_to_sector(int sector, double along, double aside);

  const PolarLayout* layout_;
  std::vector<double> radii_;
  std::vector<ObstructedUnits> layers_;
  std::vector<double> reaches_;
  std::vector<double> squares_;  ///< squared radii, for the point at hand; negative: out of reach
};

}  // namespace meander

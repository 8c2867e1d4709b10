// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
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
  void obstruct(int sector, int first, int last) {
    add(sector, std::clamp(first, 0, rings_), std::clamp(last + 1, 0, rings_));
  }
  /// Bits of the rings from first on and before `end`, both in 0 .. rings; none when first >= end.
  void add(int sector, int first, int end) {
    std::uint64_t* words = bits_.data() + static_cast<std::size_t>(sector) * words_;
    const std::uint64_t* upto = before_.data() + static_cast<std::size_t>(end) * words_;
    const std::uint64_t* from = before_.data() + static_cast<std::size_t>(first) * words_;
    for (std::size_t w = 0; w < words_; ++w) words[w] |= upto[w] & ~from[w];
  }
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
  std::vector<std::uint64_t> before_;  ///< for each ring, the bits of those before it that can be obstructed
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
  void add_to_layer(std::size_t k, const Vec2& point, double square, int sector, int count);

  const PolarLayout* layout_;
  std::vector<double> radii_;
  std::vector<ObstructedUnits> layers_;
  std::vector<double> reaches_;
  std::vector<double> squares_;  ///< squared radii, for the point at hand; negative: out of reach
};

}  // namespace meander

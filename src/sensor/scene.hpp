// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "geometry/shape_index.hpp"
#include "world/world.hpp"

namespace meander {

/// A light in the world.
struct Lamp {
  std::uint32_t slot;
  Vec2 position;
  double strength;
};

/// What sensors and bodies meet: the world's walls and poles in a ray-cast index, plus the moving discs of this instant
/// (movers and other robots). Follows the world's edits in place.
class Scene {
 public:
  /// Applies the edits of `world` not seen yet. Cheap when there are none.
  void follow(const World& world);

  const ShapeIndex& walls() const { return index_; }
  /// In the order of their slots.
  std::span<const Lamp> lamps() const { return lamps_; }
  /// Moving discs of this instant. Owners are numbered from kMovingOwner on.
  std::vector<Pole> moving;

  static constexpr std::uint32_t kMovingOwner = 1u << 30;

 private:
  void refresh(const World& world, std::uint32_t slot);

  ShapeIndex index_;
  std::vector<Lamp> lamps_;
  std::uint64_t seen_ = 0;
};

}  // namespace meander

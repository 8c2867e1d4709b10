// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "topology/growing_net.hpp"

namespace meander::topology {

/// What was sensed lately along the way, to find out where in the map a lost robot is. A single place is like many
/// others; a stretch of way is not.
class Trail {
 public:
  /// Keeps `length` situations, one every `spacing` metres.
  Trail(int length, double spacing, int stride);
  void add(const Situation& situation);
  void clear() { count_ = 0; }

  struct Place {
    Vec2 position{0, 0};  ///< where the last situation was, if this is right
    double mismatch = 0;  ///< mean over the trail: squared distance of the senses to the best cell there
  };
  /// The place of the whole map that the trail fits best; nothing until the trail is half full, or when it fits about
  /// as well where the robot believes to be. `spread` [m]: cells so near to a supposed place may be meant.
  std::optional<Place> find(const GrowingNet& net, double spread) const;

 private:
  double mismatch(const GrowingNet& net, const Vec2& shift, double spread, double limit) const;
  const float* senses(int i) const { return senses_.data() + slot(i) * stride_; }
  std::size_t slot(int i) const { return static_cast<std::size_t>((first_ + i) % length_); }

  int length_;
  double spacing_;
  std::size_t stride_;
  std::vector<Vec2> positions_;
  std::vector<float> senses_;
  int first_ = 0, count_ = 0;
};

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "geometry/shape_index.hpp"
#include "sensor/sonar_lanes.hpp"
#include "sensor/sonar_wedge.hpp"

namespace meander::sonar {

/// Eight walls or discs, relative to the centre of the list, in single precision: good enough to tell what surely lies
/// outside a wedge. Unused lanes are NaN, which lies outside everything.
struct WallBlock {
  Lanes ax[2], ay[2], bx[2], by[2];
};
struct DiscBlock {
  Lanes x[2], y[2], radius[2];
};

/// A wedge and its screen as three half-planes nx x + ny y + c >= -margin, relative to the centre of the list.
struct Cull {
  std::array<std::array<Lanes, 3>, 3> planes;
  unsigned may_touch(const WallBlock& block) const;
  unsigned may_touch(const DiscBlock& block) const;
};

/// Everything that a ring of sonars near one place can meet, nearest first.
class Candidates {
 public:
  /// Gathers the pieces that touch the disc.
  void gather(const ShapeIndex& index, const Vec2& center, double radius);
  /// Takes the moving discs that touch the gathered disc, except those of one owner.
  void set_moving(std::span<const Pole> moving, std::uint32_t except);

  const Vec2& center() const { return center_; }
  double radius() const { return radius_; }
  std::span<const Wall> walls() const { return walls_; }
  std::span<const Pole> poles() const { return poles_; }
  std::span<const Pole> moving() const { return moving_; }
  std::span<const WallBlock> wall_blocks() const { return wall_blocks_; }
  std::span<const DiscBlock> pole_blocks() const { return pole_blocks_; }
  std::span<const DiscBlock> moving_blocks() const { return moving_blocks_; }
  /// No wall (pole) from this block on is nearer to the centre [m].
  double wall_block_distance(std::size_t block) const { return wall_distance_[block]; }
  double pole_block_distance(std::size_t block) const { return pole_distance_[block]; }

  /// The materials met; `material` of walls and poles above is an index into these.
  std::span<const Material> materials() const { return materials_; }

  Cull cull(const View& view, const Wedge& wedge) const;

 private:
  std::uint16_t kind_of(const Material& material);

  Vec2 center_{0, 0};
  double radius_ = -1;
  std::vector<Wall> walls_, gathered_walls_;
  std::vector<Pole> poles_, gathered_poles_, moving_;
  std::vector<WallBlock> wall_blocks_;
  std::vector<DiscBlock> pole_blocks_, moving_blocks_;
  std::vector<double> wall_distance_, pole_distance_, distance_;
  std::vector<std::uint32_t> order_, rings_;  ///< scratch
  std::vector<Material> materials_;

  template <class Piece>
  void sort_outward(const std::vector<Piece>& from, std::vector<Piece>& to, std::vector<double>& least);
};

/// Visits the blocks of a list in the order of their distance.
class Outward {
 public:
  /// `shift`: distance of the listening place from the centre of the list.
  Outward(const Candidates& list, double shift) : list_(list), shift_(shift) { look(); }
  bool done() const { return !(next_ < kNever); }
  /// Nothing that is still to come is nearer than this [m].
  double reach() const { return next_ - shift_; }
  bool at_walls() const { return wall_next_ <= pole_next_; }
  std::size_t block() const { return at_walls() ? wall_ : pole_; }
  void advance() {
    at_walls() ? ++wall_ : ++pole_;
    look();
  }

 private:
  void look() {
    wall_next_ = wall_ < list_.wall_blocks().size() ? list_.wall_block_distance(wall_) : kNever;
    pole_next_ = pole_ < list_.pole_blocks().size() ? list_.pole_block_distance(pole_) : kNever;
    next_ = std::min(wall_next_, pole_next_);
  }
  const Candidates& list_;
  double shift_;
  std::size_t wall_ = 0, pole_ = 0;
  double wall_next_ = 0, pole_next_ = 0, next_ = 0;
};

}  // namespace meander::sonar

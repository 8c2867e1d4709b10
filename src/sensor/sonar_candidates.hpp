// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <array>
#include <bit>
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

/// Things of one kind in the order of their distance from the centre of the list, in rings; eight to a block.
template <class Thing, class Block>
struct Shelf {
  std::vector<Thing> things;
  std::vector<Block> blocks;
  std::vector<double> distance;  ///< per block: nothing from here on is nearer [m]

  double distance_from(std::size_t block) const { return block < distance.size() ? distance[block] : kNever; }

  /// Calls visit(thing, its index) for what may touch the wedge.
  template <class Visit>
  void visit_touched(std::size_t block, const Cull& cull, const Visit& visit) const {
    for (unsigned left = cull.may_touch(blocks[block]); left; left &= left - 1) {
      const auto i = static_cast<std::uint32_t>(8 * block) + static_cast<std::uint32_t>(std::countr_zero(left));
      visit(things[i], i);
    }
  }
  /// Calls visit(thing) for all of a block.
  template <class Visit>
  void visit_all(std::size_t block, const Visit& visit) const {
    for (std::size_t i = 8 * block; i < std::min(8 * block + 8, things.size()); ++i) visit(things[i]);
  }
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
  const Shelf<Face, WallBlock>& faces() const { return faces_; }
  const Shelf<Corner, DiscBlock>& corners() const { return corners_; }
  const Shelf<Pole, DiscBlock>& poles() const { return poles_; }
  const Shelf<Pole, DiscBlock>& moving() const { return moving_; }  ///< in no order

  /// The materials met; the kinds of faces and corners and `material` of poles are indices into these.
  std::span<const Material> materials() const { return materials_; }

  Cull cull(const View& view, const Wedge& wedge) const;

 private:
  std::uint16_t kind_of(const Material& material);
  template <class Thing, class Block>
  void sort_outward(const std::vector<Thing>& from, Shelf<Thing, Block>& to);

  Vec2 center_{0, 0};
  double radius_ = -1;
  Shelf<Face, WallBlock> faces_;
  Shelf<Corner, DiscBlock> corners_;
  Shelf<Pole, DiscBlock> poles_, moving_;
  std::vector<Material> materials_;

  // Scratch of gather.
  std::vector<Wall> gathered_walls_;
  std::vector<Face> gathered_faces_;
  std::vector<Corner> gathered_corners_;
  std::vector<Pole> gathered_poles_;
  std::vector<double> distance_;
  std::vector<std::uint32_t> order_, rings_;
};

/// Visits the blocks of faces and poles in the order of their distance.
class Outward {
 public:
  /// `shift`: distance of the listening place from the centre of the list.
  Outward(const Candidates& list, double shift) : list_(list), shift_(shift) { look(); }
  bool done() const { return !(next_ < kNever); }
  /// Nothing that is still to come is nearer than this [m].
  double reach() const { return next_ - shift_; }
  bool at_faces() const { return face_next_ <= pole_next_; }
  std::size_t block() const { return at_faces() ? face_ : pole_; }
  void advance() {
    at_faces() ? ++face_ : ++pole_;
    look();
  }

 private:
  void look() {
    face_next_ = list_.faces().distance_from(face_);
    pole_next_ = list_.poles().distance_from(pole_);
    next_ = std::min(face_next_, pole_next_);
  }
  const Candidates& list_;
  double shift_;
  std::size_t face_ = 0, pole_ = 0;
  double face_next_ = 0, pole_next_ = 0, next_ = 0;
};

}  // namespace meander::sonar

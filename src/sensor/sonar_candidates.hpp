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
  unsigned convex_a = 0, convex_b = 0;  ///< bit i: that end of wall i is a convex corner
};
struct DiscBlock {
  Lanes x[2], y[2], radius[2];
};

/// The side of a line that counts: nx x + ny y + c >= 0, relative to the centre of the list, rounding allowed for.
struct HalfPlane {
  Lanes nx, ny, c;
  Lanes length;  ///< of the normal, or more
  LaneMask has(Lanes x, Lanes y) const { return nx * x + (ny * y + c) >= all(0); }
  LaneMask touches(Lanes x, Lanes y, Lanes r) const { return nx * x + (ny * y + c) + length * r >= all(0); }
};

/// What may touch a wedge: bit i stands for wall i of a block and its ends.
struct Touched {
  unsigned walls, a, b;
};

/// A wedge and its screen: what lies outside one of the half-planes does not touch it.
struct Cull {
  HalfPlane low, high, screen;
  bool screened;

  Touched may_touch(const WallBlock& block) const {
    const Touched first = touched(block, 0), second = touched(block, 1);
    return {first.walls | second.walls << 4, first.a | second.a << 4, first.b | second.b << 4};
  }
  unsigned may_touch(const DiscBlock& block) const { return touched(block, 0) | touched(block, 1) << 4; }

 private:
  Touched touched(const WallBlock& k, int half) const {
    const Lanes ax = k.ax[half], ay = k.ay[half], bx = k.bx[half], by = k.by[half];
    const LaneMask low_a = low.has(ax, ay), low_b = low.has(bx, by), high_a = high.has(ax, ay),
                   high_b = high.has(bx, by);
    LaneMask in = (low_a | low_b) & (high_a | high_b), a = low_a & high_a, b = low_b & high_b;
    if (screened) {
      const LaneMask screen_a = screen.has(ax, ay), screen_b = screen.has(bx, by);
      in &= screen_a | screen_b, a &= screen_a, b &= screen_b;
    }
    return {bits(in), bits(a), bits(b)};
  }
  unsigned touched(const DiscBlock& k, int half) const {
    const Lanes x = k.x[half], y = k.y[half], radius = k.radius[half];
    LaneMask in = low.touches(x, y, radius) & high.touches(x, y, radius);
    if (screened) in &= screen.touches(x, y, radius);
    return bits(in);
  }
};

/// Calls visit(i) for every bit of a block, i counted over all blocks.
template <class Visit>
void for_bits(unsigned set, std::size_t block, const Visit& visit) {
  for (; set; set &= set - 1)
    visit(static_cast<std::uint32_t>(8 * block) + static_cast<std::uint32_t>(std::countr_zero(set)));
}

/// Things of one kind in the order of their distance from the centre of the list, in rings; eight to a block.
template <class Thing, class Block>
struct Shelf {
  std::vector<Thing> things;
  std::vector<Block> blocks;
  std::vector<double> distance = {kNever};  ///< per block: nothing from here on is nearer [m]; kNever at the end

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
  const Shelf<Pole, DiscBlock>& poles() const { return poles_; }
  const Shelf<Pole, DiscBlock>& moving() const { return moving_; }  ///< in no order

  /// The materials met; the kinds of faces and `material` of poles are indices into these.
  std::span<const Material> materials() const { return materials_; }

  Cull cull(const View& view, const Wedge& wedge) const;

 private:
  std::uint32_t kind_of(const Material& material);
  void number_materials(const ShapeIndex& index);
  template <class Thing, class Block>
  void sort_outward(const std::vector<Thing>& from, Shelf<Thing, Block>& to);

  Vec2 center_{0, 0};
  double radius_ = -1;
  Shelf<Face, WallBlock> faces_;
  Shelf<Pole, DiscBlock> poles_, moving_;
  std::vector<Material> materials_;

  // Scratch of gather.
  std::vector<Wall> gathered_walls_;
  std::vector<Face> gathered_faces_;
  std::vector<Pole> gathered_poles_;
  std::vector<double> distance_;
  std::vector<std::uint32_t> order_, rings_;
};

/// Visits the blocks of faces and poles in the order of their distance.
class Outward {
 public:
  /// `shift`: distance of the listening place from the centre of the list.
  Outward(const Candidates& list, double shift) : list_(list), shift_(shift) { look(); }
  /// Nothing that is still to come is nearer than this [m]; kNever: nothing is.
  double reach() const { return next_ - shift_; }
  bool at_faces() const { return face_next_ <= pole_next_; }
  std::size_t block() const { return at_faces() ? face_ : pole_; }
  void advance() {
    at_faces() ? ++face_ : ++pole_;
    look();
  }

 private:
  void look() {
    face_next_ = list_.faces().distance[face_];
    pole_next_ = list_.poles().distance[pole_];
    next_ = std::min(face_next_, pole_next_);
  }
  const Candidates& list_;
  double shift_;
  std::size_t face_ = 0, pole_ = 0;
  double face_next_ = 0, pole_next_ = 0, next_ = 0;
};

}  // namespace meander::sonar

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes.hpp"

namespace meander {

/// What surfaces do to sound. NaN: the sensor's own value holds.
struct Material {
  double echo = 1;  ///< strength in [0, 1]; 0: never answers, still blocks
  double specular_limit = std::numeric_limits<double>::quiet_NaN();  ///< largest |incidence| that echoes [rad]
};

/// One straight piece of wall in the index. Solids lie to the left of a -> b. A convex end answers as a point
/// scatterer; each corner belongs to one wall, as its a.
struct Wall {
  Vec2 a, b;
  std::uint32_t owner = 0;     ///< slot of the obstacle it belongs to
  std::uint32_t material = 0;  ///< see ShapeIndex::material()
  bool convex_a = false;       ///< convex corner of a solid; any bend or free end of a chain (seen from its outer side)
  bool convex_b = false;       ///< the free end of an open chain
  bool solid = true;           ///< border of a solid (false: thin wall of a chain)
};

struct Pole {
  Disc disc;
  std::uint32_t owner = 0;
  std::uint32_t material = 0;
};

struct RayHit {
  double range;  ///< [m] from the origin
  Vec2 point;
  double cos_incidence;  ///< of the angle between the ray and the surface normal, in [0, 1]
  std::uint32_t owner;

  /// Angle between the ray and the surface normal, in [0, pi/2].
  double incidence() const { return angle_of(std::sqrt(1 - cos_incidence * cos_incidence), cos_incidence); }
};

/// Uniform grid over walls and poles, edited in place. Exact: every query returns what a loop over all pieces would.
/// Positions anywhere in the plane are fine, also outside everything that was inserted.
class ShapeIndex {
 public:
  explicit ShapeIndex(double cell = 1.0);
  ShapeIndex(const ShapeIndex&);
  ShapeIndex& operator=(const ShapeIndex&);
  ShapeIndex(ShapeIndex&&) noexcept;
  ShapeIndex& operator=(ShapeIndex&&) noexcept;
  ~ShapeIndex();

  /// Adds the border of a valid shape under an owner slot (one shape per owner; owners are small dense numbers).
  void insert(std::uint32_t owner, const Shape& shape, const Material& material = {});
  void remove(std::uint32_t owner);
  bool has(std::uint32_t owner) const;
  void clear();

  std::size_t wall_count() const;
  const Material& material(std::uint32_t index) const;

  /// First piece hit by the ray within max_range, if any. `direction` is a unit vector. From inside a solid the border
  /// is seen from inside.
  std::optional<RayHit> cast(const Vec2& origin, const Vec2& direction, double max_range) const;

  /// Distance [m] to the nearest piece, at most `most`. Not signed: see inside().
  double distance(const Vec2& point, double most) const;

  /// Is the point inside a solid (parity of each owner's border; discs exactly)? On the border counts as inside.
  bool inside(const Vec2& point) const;

  /// All pieces that touch the disc, each once, in a canonical order (independent of the editing history).
  void gather(const Vec2& center, double radius, std::vector<Wall>& walls, std::vector<Pole>& poles) const;

  /// Calls for all pieces that touch the disc, in no particular order and for some repeatedly. Takes no memory.
  void around(const Vec2& center, double radius, const std::function<void(const Wall&)>& wall,
              const std::function<void(const Disc&)>& disc) const;

  /// Counts edits; `touched_since` tells whether an edit after `revision` may have changed anything in the disc.
  std::uint64_t revision() const;
  bool touched_since(std::uint64_t revision, const Vec2& center, double radius) const;

  /// A token of this very index; a copy has its own. Revisions compare only under the same token, and one that is held
  /// is never given to another index.
  const std::shared_ptr<const char>& identity() const { return identity_; }

 private:
  struct State;
  std::shared_ptr<const char> identity_ = std::make_shared<const char>();
  std::unique_ptr<State> state_;
};

}  // namespace meander

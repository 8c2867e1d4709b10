// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/pose.hpp"

namespace meander {

/// Points this near to a border lie on it [m]; well above the rounding of coordinates within kFarthest.
inline constexpr double kTouch = 1e-9;
/// Least length of an edge and least size of a shape [m].
inline constexpr double kShortest = 1e-6;
/// Largest coordinate and largest size [m].
inline constexpr double kFarthest = 1e6;
/// Most points of one shape.
inline constexpr std::size_t kMostPoints = 1'000'000;

/// Thin walls through `points` (>= 2), joined back to the first when closed.
struct Chain {
  std::vector<Vec2> points;
  bool closed = false;
  bool operator==(const Chain&) const = default;
};

/// Solid area: outer ring (>= 3 points, counter-clockwise when canonical) less the holes (clockwise when canonical).
struct Polygon {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
  bool operator==(const Polygon&) const = default;
};

/// Solid rectangle around `center`, size = {along x, along y} of its own frame, turned by `heading`.
struct Rectangle {
  Vec2 center{0, 0};
  Vec2 size{0, 0};
  double heading = 0;
  bool operator==(const Rectangle&) const = default;
};

/// Solid disc.
struct Disc {
  Vec2 center{0, 0};
  double radius = 0;
  bool operator==(const Disc&) const = default;
};

using Shape = std::variant<Chain, Polygon, Rectangle, Disc>;

/// Why the shape is unusable ("points 3 and 7: edges cross at (1.20, 3.40)"), or nothing when it is valid: finite
/// numbers, enough points, no zero-length edge, no self-crossing ring, holes inside the outer ring and apart, sizes >
/// 0.
std::optional<std::string> invalid(const Shape& shape);

/// Orders rings as documented above (outer counter-clockwise, holes clockwise). Other shapes are returned as they are.
Shape canonical(Shape shape);

Shape moved(const Shape& shape, const Vec2& by);
Shape turned(const Shape& shape, double by, const Vec2& about);
Shape scaled(const Shape& shape, double factor, const Vec2& about);

Box bounding_box(const Shape& shape);
/// Centre of the bounding box; `center` of rectangles and discs.
Vec2 center(const Shape& shape);

/// Is the point inside the solid (chains have no inside)? Points on the rim count as inside.
bool contains(const Shape& shape, const Vec2& point);

/// Distance [m] from the point to the nearest point of the shape; 0 inside solids.
double distance(const Shape& shape, const Vec2& point);

/// Distance from `point` to the segment a-b.
double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b);

/// Counter-clockwise.
std::array<Vec2, 4> corners(const Rectangle& rectangle);

/// The rings of a shape's border: open or closed runs of points. Discs have none (they are exact, not faceted).
struct Ring {
  std::vector<Vec2> points;
  bool closed;
};
std::vector<Ring> rings(const Shape& shape);

}  // namespace meander

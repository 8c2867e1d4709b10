// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/fields.hpp"
#include "geometry/shape_index.hpp"
#include "geometry/shapes.hpp"

namespace meander {

/// Handle of a thing in a world. A removed thing's id never comes back, except by undoing the removal.
struct Id {
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  bool operator==(const Id&) const = default;
  auto operator<=>(const Id&) const = default;
};

/// NaN-free form of Material for files and edits.
struct Surface {
  double echo = 1;                       ///< strength in [0, 1]
  std::optional<double> specular_limit;  ///< [rad]; none: the sensor's own
  bool operator==(const Surface&) const = default;
};

struct Obstacle {
  std::string name;
  Shape shape;
  Surface surface;
  bool operator==(const Obstacle&) const = default;
};

/// An obstacle that opens and closes; while open it is not there.
struct Door {
  std::string name;
  Shape shape;
  bool open = false;
  Surface surface;
  bool operator==(const Door&) const = default;
};

enum class Motion { waypoints, random_walk };
template <>
struct EnumNames<Motion> {
  static constexpr std::pair<Motion, const char*> entries[] = {{Motion::waypoints, "waypoints"},
                                                               {Motion::random_walk, "random_walk"}};
};

/// A disc that moves by itself once a simulation runs.
struct Mover {
  std::string name;
  Disc disc;  ///< where it starts
  Motion motion = Motion::waypoints;
  std::vector<Vec2> waypoints;  ///< visited in a round, from `disc.center` on
  double speed = 0.5;           ///< [m/s]
  bool yields = true;           ///< stops for robots that stand in its way; false: blind
  bool operator==(const Mover&) const = default;
};

struct Light {
  std::string name;
  Vec2 position{0, 0};
  double strength = 1;
  bool operator==(const Light&) const = default;
};

/// A named pose with a tolerance: subgoals are given as places.
struct Place {
  std::string name;
  Vec2 position{0, 0};
  std::optional<double> heading;
  double tolerance = 0.25;
  bool operator==(const Place&) const = default;
};

using Item = std::variant<Obstacle, Door, Mover, Light, Place>;

inline const std::string& name_of(const Item& item) {
  return std::visit([](const auto& thing) -> const std::string& { return thing.name; }, item);
}

/// "obstacle", "door", "mover", "light" or "place".
const char* kind_of(const Item& item);

/// The shape that blocks the way now: of obstacles and closed doors; nothing for the rest.
const Shape* blocking_shape(const Item& item);

Material material_of(const Surface& surface);

}  // namespace meander

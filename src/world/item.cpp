// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/item.hpp"

#include <limits>

namespace meander {

const char* kind_of(const Item& item) {
  static constexpr const char* kKinds[] = {"obstacle", "door", "mover", "light", "place"};
  static_assert(std::size(kKinds) == std::variant_size_v<Item>);
  return kKinds[item.index()];
}

const Shape* blocking_shape(const Item& item) {
  if (const auto* obstacle = std::get_if<Obstacle>(&item)) return &obstacle->shape;
  if (const auto* door = std::get_if<Door>(&item)) return door->open ? nullptr : &door->shape;
  return nullptr;
}

Material material_of(const Surface& surface) {
  return {surface.echo, surface.specular_limit.value_or(std::numeric_limits<double>::quiet_NaN())};
}

}  // namespace meander

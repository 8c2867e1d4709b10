// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "world/item.hpp"

namespace meander {

/// What is true of the whole world.
struct Header {
  std::string title;
  std::string note;  ///< what the world shows, and its source
  Box bounds{{0, 0}, {10, 10}};
  std::optional<Pose2> start;
  bool operator==(const Header&) const = default;
};

/// The complete list of things that can be done to a world. Each is a value, and each has an inverse among them.
struct Add {
  Id id;
  Item item;
  bool operator==(const Add&) const = default;
};
struct Remove {
  Id id;
  bool operator==(const Remove&) const = default;
};
/// Moving, turning, scaling, renaming, opening and closing all are this.
struct Replace {
  Id id;
  Item item;
  bool operator==(const Replace&) const = default;
};
struct SetHeader {
  Header header;
  bool operator==(const SetHeader&) const = default;
};
using Edit = std::variant<Add, Remove, Replace, SetHeader>;

/// The item that the edit gives to the id, or nullptr.
inline const Item* item_of(const Edit& edit, Id id) {
  const auto* add = std::get_if<Add>(&edit);
  if (add && add->id == id) return &add->item;
  const auto* replace = std::get_if<Replace>(&edit);
  return replace && replace->id == id ? &replace->item : nullptr;
}

}  // namespace meander

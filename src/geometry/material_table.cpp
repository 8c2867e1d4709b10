// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/material_table.hpp"

#include <bit>

namespace meander {

std::uint32_t MaterialTable::take(const Material& material) {
  const Key key = key_of(material);
  if (const auto found = numbers_.find(key); found != numbers_.end()) {
    ++entries_[found->second].users;
    return found->second;
  }
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(entries_.size()));
    entries_.emplace_back();
  }
  const std::uint32_t number = free_.back();
  numbers_.emplace(key, number);
  free_.pop_back();
  entries_[number] = {material, 1};
  return number;
}

void MaterialTable::release(std::uint32_t number) {
  Entry& entry = entries_.at(number);
  if (--entry.users > 0) return;
  numbers_.erase(key_of(entry.material));
  free_.push_back(number);
}

/// The bits of both numbers, because NaN has no place in an order.
MaterialTable::Key MaterialTable::key_of(const Material& material) {
  return {std::bit_cast<std::uint64_t>(material.echo), std::bit_cast<std::uint64_t>(material.specular_limit)};
}

}  // namespace meander

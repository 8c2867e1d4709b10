// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/shape_index.hpp"

namespace meander {

/// Numbers for the materials in use: equal ones share a number, and a number that nobody uses any more is given again.
class MaterialTable {
 public:
  /// The number of the material, which has one user more.
  std::uint32_t take(const Material& material);
  void release(std::uint32_t number);
  const Material& at(std::uint32_t number) const { return entries_.at(number).material; }

 private:
  struct Entry {
    Material material;
    std::uint32_t users = 0;
  };
  using Key = std::pair<std::uint64_t, std::uint64_t>;
  static Key key_of(const Material& material);

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> free_;
  std::map<Key, std::uint32_t> numbers_;  ///< of those in use
};

}  // namespace meander

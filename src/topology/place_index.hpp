// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/vec.hpp"

namespace meander::topology {

/// Finds cells by place at an effort that does not grow with their number: square buckets in an open hash table, the
/// cells of a bucket in a list.
class PlaceIndex {
 public:
  /// `side` of a bucket [m]: everything within `side` of a place lies in the 3 x 3 buckets around it.
  explicit PlaceIndex(double side);
  double side() const { return side_; }

  void add(int cell, const Vec2& at);
  void remove(int cell);
  /// The cell is somewhere else now.
  void move(int cell, const Vec2& at);
  void clear();

  /// Calls visit(cell) for every cell in the buckets that the square of half side `reach` around the place touches.
  template <class Visit>
  void around(const Vec2& at, double reach, Visit visit) const {
    const std::int64_t x1 = bucket(at.x() + reach), y1 = bucket(at.y() + reach);
    for (std::int64_t y = bucket(at.y() - reach); y <= y1; ++y)
      for (std::int64_t x = bucket(at.x() - reach); x <= x1; ++x)
        for (int cell = head(key(x, y)); cell >= 0; cell = links_[static_cast<std::size_t>(cell)].next) visit(cell);
  }

 private:
  struct Bucket {
    std::uint64_t key = 0;
    int head = kFree;
  };
  struct Place {
    std::uint64_t key = 0;
    int next = -1, before = -1;
  };
  static constexpr int kFree = -2;  ///< head of a bucket that nobody has used

  std::int64_t bucket(double metres) const;
  /// Places repeat after 2^32 buckets.
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return (static_cast<std::uint64_t>(x) & 0xffffffffULL) << 32 | (static_cast<std::uint64_t>(y) & 0xffffffffULL);
  }
  std::size_t slot(std::uint64_t key) const;
  int head(std::uint64_t key) const { return table_[slot(key)].head; }
  void grow();

  double side_;
  std::vector<Bucket> table_;  ///< power of two, at most half full
  std::size_t used_ = 0;
  std::vector<Place> links_;  ///< by cell
};

}  // namespace meander::topology

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

  /// Calls visit(cell) for every cell in the buckets that the square of half side `reach` around the place touches, and
  /// for others when those are more buckets than the table has.
  template <class Visit>
  void around(const Vec2& at, double reach, Visit visit) const {
    const std::int64_t x0 = bucket(at.x() - reach), x1 = bucket(at.x() + reach);
    const std::int64_t y0 = bucket(at.y() - reach), y1 = bucket(at.y() + reach);
    if (static_cast<double>(x1 - x0 + 1) * static_cast<double>(y1 - y0 + 1) > static_cast<double>(table_.size())) {
      for (const Bucket& every : table_) visit_list(every.head, visit);
      return;
    }
    for (std::int64_t y = y0; y <= y1; ++y)
      for (std::int64_t x = x0; x <= x1; ++x) visit_list(head(key(x, y)), visit);
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
  template <class Visit>
  void visit_list(int cell, Visit& visit) const {
    for (; cell >= 0; cell = links_[static_cast<std::size_t>(cell)].next) visit(cell);
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

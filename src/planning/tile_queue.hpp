// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace meander {

/// Units by key, those of the least first, in the order in which they came. Keys before the bucket in turn count as its
/// own, keys far behind it wait in the last bucket.
class TileQueue {
 public:
  TileQueue() : buckets_(kBuckets) {}

  /// Returns the key under which it waits.
  std::int32_t push(std::int32_t unit, std::int32_t key) {
    key = std::clamp(key, turn_, turn_ + kBuckets - 1);
    buckets_[static_cast<std::size_t>(key % kBuckets)].push_back(unit);
    ++size_;
    return key;
  }
  /// Takes out the units of the nearest bucket that has any; false: there are none left.
  bool pop(std::vector<std::int32_t>& units) {
    units.clear();
    if (size_ == 0) return false;
    while (buckets_[static_cast<std::size_t>(turn_ % kBuckets)].empty()) ++turn_;
    units.swap(buckets_[static_cast<std::size_t>(turn_ % kBuckets)]);
    size_ -= units.size();
    return true;
  }
  std::int32_t turn() const { return turn_; }

 private:
  static constexpr std::int32_t kBuckets = 4096;
  std::vector<std::vector<std::int32_t>> buckets_;
  std::int32_t turn_ = 0;
  std::size_t size_ = 0;
};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

namespace meander {

/// Items by cost, a few at a time: those of a bucket come in any order. As long as no item is pushed that is more than
/// `spread` above the bucket in turn, the buckets go round and need no heap. Where `width` is at most the least cost of
/// a step, an item that comes out is final.
class BucketQueue {
 public:
  BucketQueue(double width, double spread)
      : per_cost_(1 / width), buckets_(static_cast<std::size_t>(std::ceil(spread / width)) + 2) {}

  void push(double cost, std::int32_t item) {
    buckets_[static_cast<std::size_t>(cost * per_cost_) % buckets_.size()].push_back(item);
    ++size_;
  }
  /// Takes out the items of the nearest bucket that has any; false: there are none left.
  bool pop(std::vector<std::int32_t>& items) {
    items.clear();
    if (size_ == 0) return false;
    while (buckets_[turn_ % buckets_.size()].empty()) ++turn_;
    items.swap(buckets_[turn_ % buckets_.size()]);
    size_ -= items.size();
    return true;
  }
  /// Does the cost belong to the bucket that came out last? If not, the item came out before, at less.
  bool in_turn(double cost) const { return static_cast<std::size_t>(cost * per_cost_) == turn_; }

 private:
  double per_cost_;
  std::vector<std::vector<std::int32_t>> buckets_;
  std::size_t turn_ = 0;
  std::size_t size_ = 0;
};

}  // namespace meander

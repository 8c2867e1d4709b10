// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace meander {

/// A short list inside a RunPool; it owns bit_ceil(count) items there.
struct PoolRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Many short lists in one block of memory. A list that outgrows its power of two moves; what it leaves is used again
/// by lists of that size, so that editing back and forth takes no new memory.
template <class T>
class RunPool {
 public:
  T* begin(const PoolRun& run) { return items_.data() + run.first; }
  T* end(const PoolRun& run) { return begin(run) + run.count; }
  std::span<const T> items(const PoolRun& run) const { return {items_.data() + run.first, run.count}; }
  T& operator[](std::uint32_t index) { return items_[index]; }
  const T& operator[](std::uint32_t index) const { return items_[index]; }
  const T* data() const { return items_.data(); }
  std::size_t size() const { return items_.size(); }

  /// Changes the length; items up to the smaller length are kept, new ones are left over from other lists.
  void resize(PoolRun& run, std::uint32_t count) {
    const std::uint32_t before = capacity(run.count), after = capacity(count);
    if (before != after) {
      const std::uint32_t first = take(after);
      std::copy_n(begin(run), std::min(run.count, count), items_.data() + first);
      give(run.first, before);
      run.first = first;
    }
    run.count = count;
  }

  void push(PoolRun& run, const T& item) {
    resize(run, run.count + 1);
    *(end(run) - 1) = item;
  }

  /// Removes the item by putting the last one in its place.
  void erase(PoolRun& run, T* item) {
    *item = *(end(run) - 1);
    resize(run, run.count - 1);
  }

 private:
  static std::uint32_t capacity(std::uint32_t count) { return count == 0 ? 0 : std::bit_ceil(count); }

  std::uint32_t take(std::uint32_t capacity) {
    if (capacity == 0) return 0;
    auto& free = free_[static_cast<std::size_t>(std::countr_zero(capacity))];
    if (!free.empty()) {
      const std::uint32_t first = free.back();
      free.pop_back();
      return first;
    }
    items_.resize(items_.size() + capacity);
    return static_cast<std::uint32_t>(items_.size() - capacity);
  }
  void give(std::uint32_t first, std::uint32_t capacity) {
    if (capacity != 0) free_[static_cast<std::size_t>(std::countr_zero(capacity))].push_back(first);
  }

  std::vector<T> items_;
  std::array<std::vector<std::uint32_t>, 32> free_;  ///< starts of unused runs, by the logarithm of their size
};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meander {

/// A set of numbers below a bound, one bit each, searched in ascending or descending order.
class NumberSet {
 public:
  explicit NumberSet(std::size_t bound = 0) { clear(bound); }
  void clear(std::size_t bound) { words_.assign(bound / 64 + 1, 0); }

  void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  void erase(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }

  /// The least number in [first, end), or end.
  std::size_t next(std::size_t first, std::size_t end) const {
    while (first < end) {
      const std::uint64_t rest = words_[first / 64] >> (first % 64);
      if (rest != 0) {
        first += static_cast<std::size_t>(std::countr_zero(rest));
        return first < end ? first : end;
      }
      first += 64 - first % 64;
    }
    return end;
  }

  /// One more than the greatest number in [first, end), or first.
  std::size_t last(std::size_t first, std::size_t end) const {
    while (first < end) {
      const std::uint64_t rest = words_[(end - 1) / 64] << (63 - (end - 1) % 64);
      if (rest != 0) {
        const auto skipped = static_cast<std::size_t>(std::countl_zero(rest));
        return end - first > skipped ? end - skipped : first;
      }
      end = (end - 1) / 64 * 64;
    }
    return first;
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace meander

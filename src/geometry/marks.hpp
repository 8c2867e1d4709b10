// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

namespace meander {

/// A set of small numbers, walked in ascending order.
class Marks {
 public:
  void reset(std::size_t size) { words_.assign(size / 64 + 1, 0); }
  void set(std::uint32_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  /// Calls visit(i) for every marked i in [first, end).
  template <class Visit>
  void for_each(std::uint32_t first, std::uint32_t end, Visit visit) const {
    for (std::uint32_t i = first; i < end;) {
      const std::uint64_t rest = words_[i / 64] >> (i % 64);
      i += rest == 0 ? 64 - i % 64 : static_cast<std::uint32_t>(std::countr_zero(rest));
      if (rest != 0 && i < end) visit(i++);
    }
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <new>
#include <vector>

namespace meander::polar {

/// Allocates from the beginning of a cache line on: registers as wide as one are then read and written in one go.
template <class T>
struct CacheLines {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};
  CacheLines() = default;
  template <class U>
  CacheLines(const CacheLines<U>&) {}
  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), kLine)); }
  void deallocate(T* at, std::size_t) { ::operator delete(at, kLine); }
  bool operator==(const CacheLines&) const = default;
};

using AlignedNumbers = std::vector<double, CacheLines<double>>;

}  // namespace meander::polar

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/log_odds.hpp"

#include <algorithm>
#include <cstring>

namespace meander {
namespace {

using Four = float __attribute__((vector_size(16)));
using Eight = float __attribute__((vector_size(32)));

/// Several cells at a time: the same bits however many.
template <class Lanes>
[[gnu::always_inline]] inline void add(float* cells, const float* increments, std::size_t count, float limit) {
  constexpr std::size_t kWide = sizeof(Lanes) / sizeof(float);
  const Lanes high = Lanes{} + limit, low = -high;
  std::size_t k = 0;
  for (; k + kWide <= count; k += kWide) {
    Lanes sum, more;
    std::memcpy(&sum, cells + k, sizeof sum);
    std::memcpy(&more, increments + k, sizeof more);
    sum += more;
    sum = sum < high ? sum : high;
    sum = sum > low ? sum : low;
    std::memcpy(cells + k, &sum, sizeof sum);
  }
  for (; k < count; ++k) cells[k] = std::max(std::min(cells[k] + increments[k], limit), -limit);
}

using Add = void (*)(float*, const float*, std::size_t, float);

void add_4(float* cells, const float* increments, std::size_t count, float limit) {
  add<Four>(cells, increments, count, limit);
}

#ifdef __x86_64__
[[gnu::target("avx2")]] void add_8(float* cells, const float* increments, std::size_t count, float limit) {
  add<Eight>(cells, increments, count, limit);
}
Add widest() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") ? add_8 : add_4;
}
#else
Add widest() { return add_4; }
#endif

}  // namespace

void add_evidence(float* cells, const float* increments, std::size_t count, float limit) {
  static const Add kAdd = widest();
  kAdd(cells, increments, count, limit);
}

}  // namespace meander

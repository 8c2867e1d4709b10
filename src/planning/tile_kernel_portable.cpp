// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <bit>
#include <cmath>

#include "planning/tile_kernel.hpp"
#include "planning/tile_kernels.hpp"

namespace meander {
namespace {

struct Row {
  double v[kTile];

  static Row all(double x) {
    Row row;
    for (double& lane : row.v) lane = x;
    return row;
  }
  static Row load(const double* from) {
    Row row;
    std::copy_n(from, kTile, row.v);
    return row;
  }
  void store(double* to) const { std::copy_n(v, kTile, to); }
  template <class F>
  static Row each(F f) {
    Row row;
    for (int i = 0; i < kTile; ++i) row.v[i] = f(i);
    return row;
  }
  friend Row operator+(const Row& a, const Row& b) {
    return each([&](int i) { return a.v[i] + b.v[i]; });
  }
  friend Row operator-(const Row& a, const Row& b) {
    return each([&](int i) { return a.v[i] - b.v[i]; });
  }
  friend Row operator*(const Row& a, const Row& b) {
    return each([&](int i) { return a.v[i] * b.v[i]; });
  }
  friend Row operator/(const Row& a, const Row& b) {
    return each([&](int i) { return a.v[i] / b.v[i]; });
  }
  Row magnitude() const {
    return each([&](int i) { return std::abs(v[i]); });
  }
  Row larger(const Row& b) const {
    return each([&](int i) { return v[i] > b.v[i] ? v[i] : b.v[i]; });
  }
  Row masked(std::uint32_t mask) const {
    return each([&](int i) { return (mask >> i & 1) != 0 ? v[i] : 0.0; });
  }
  /// Bit i: lane i is larger than y's.
  std::uint32_t above(const Row& y) const {
    std::uint32_t bits = 0;
    for (int i = 0; i < kTile; ++i) bits |= static_cast<std::uint32_t>(v[i] > y.v[i]) << i;
    return bits;
  }
  friend Row masked_sum(const Row& x, std::uint32_t of_x, const Row& y, std::uint32_t of_y) {
    return x.masked(of_x) + y.masked(of_y);
  }
  Row from_left(double in) const {
    return each([&](int i) { return i == 0 ? in : v[i - 1]; });
  }
  Row from_right(double in) const {
    return each([&](int i) { return i == kTile - 1 ? in : v[i + 1]; });
  }
  double most() const { return *std::max_element(v, v + kTile); }
  static void transpose(const double (*from)[kTile], double (*to)[kTile]) {
    for (int r = 0; r < kTile; ++r)
      for (int c = 0; c < kTile; ++c) to[c][r] = from[r][c];
  }
};

/// Largest log2(d / x) seen, times 2^20, from the upper halves of the doubles.
class Change {
 public:
  void see(const Row& d, const Row& x) {
    for (int i = 0; i < kTile; ++i) most_ = std::max(most_, upper(d.v[i]) - upper(x.v[i]));
  }
  std::int32_t most() const { return most_; }

 private:
  static std::int32_t upper(double x) { return static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(x) >> 32); }
  std::int32_t most_ = INT32_MIN;
};

}  // namespace
}  // namespace meander

#include "planning/tile_kernel_rows.hpp"

namespace meander {
const TileKernel kPortableTileKernel{"portable", relax, residual};
}  // namespace meander

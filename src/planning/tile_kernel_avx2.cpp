// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#if defined(__x86_64__)
#include <immintrin.h>

#include "planning/tile_kernels.hpp"

namespace meander {
namespace {

alignas(32) constexpr std::int64_t kLanes[16][4] = {{0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},
                                                    {0, 0, -1, 0},  {-1, 0, -1, 0},  {0, -1, -1, 0},  {-1, -1, -1, 0},
                                                    {0, 0, 0, -1},  {-1, 0, 0, -1},  {0, -1, 0, -1},  {-1, -1, 0, -1},
                                                    {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};

struct Row {
  __m256d v[4];

  template <class F>
  static Row each(F f) {
    return {f(0), f(1), f(2), f(3)};
  }
  static Row all(double x) {
    return each([&](int) { return _mm256_set1_pd(x); });
  }
  static Row load(const double* from) {
    return each([&](int i) { return _mm256_load_pd(from + 4 * i); });
  }
  void store(double* to) const {
    for (int i = 0; i < 4; ++i) _mm256_store_pd(to + 4 * i, v[i]);
  }
  friend Row operator+(const Row& x, const Row& y) {
    return each([&](int i) { return _mm256_add_pd(x.v[i], y.v[i]); });
  }
  friend Row operator-(const Row& x, const Row& y) {
    return each([&](int i) { return _mm256_sub_pd(x.v[i], y.v[i]); });
  }
  friend Row operator*(const Row& x, const Row& y) {
    return each([&](int i) { return _mm256_mul_pd(x.v[i], y.v[i]); });
  }
  friend Row operator/(const Row& x, const Row& y) {
    return each([&](int i) { return _mm256_div_pd(x.v[i], y.v[i]); });
  }
  Row magnitude() const {
    return each([&](int i) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), v[i]); });
  }
  Row larger(const Row& y) const {
    return each([&](int i) { return _mm256_max_pd(v[i], y.v[i]); });
  }
  Row masked(std::uint32_t mask) const {
    return each([&](int i) {
      return _mm256_and_pd(
          v[i], _mm256_castsi256_pd(_mm256_load_si256(reinterpret_cast<const __m256i*>(kLanes[mask >> 4 * i & 15]))));
    });
  }
  std::uint32_t above(const Row& y) const {
    int bits = 0;
    for (int i = 0; i < 4; ++i) bits |= _mm256_movemask_pd(_mm256_cmp_pd(v[i], y.v[i], _CMP_GT_OQ)) << 4 * i;
    return static_cast<std::uint32_t>(bits);
  }
  friend Row masked_sum(const Row& x, std::uint32_t of_x, const Row& y, std::uint32_t of_y) {
    return x.masked(of_x) + y.masked(of_y);
  }
  Row from_left(double in) const {
    return each([&](int i) {
      const __m256d across = _mm256_permute2f128_pd(i == 0 ? _mm256_set1_pd(in) : v[i - 1], v[i], 0x21);
      return _mm256_shuffle_pd(across, v[i], 5);
    });
  }
  Row from_right(double in) const {
    return each([&](int i) {
      const __m256d across = _mm256_permute2f128_pd(v[i], i == 3 ? _mm256_set1_pd(in) : v[i + 1], 0x21);
      return _mm256_shuffle_pd(v[i], across, 5);
    });
  }
  double most() const {
    alignas(32) double lanes[4];
    _mm256_store_pd(lanes, _mm256_max_pd(_mm256_max_pd(v[0], v[1]), _mm256_max_pd(v[2], v[3])));
    const double low = lanes[0] > lanes[1] ? lanes[0] : lanes[1], high = lanes[2] > lanes[3] ? lanes[2] : lanes[3];
    return low > high ? low : high;
  }
  static void transpose_four(const double* from, double* to) {
    const __m256d a = _mm256_load_pd(from), b = _mm256_load_pd(from + kTile), c = _mm256_load_pd(from + 2 * kTile),
                  d = _mm256_load_pd(from + 3 * kTile);
    const __m256d ab = _mm256_unpacklo_pd(a, b), cd = _mm256_unpacklo_pd(c, d);
    const __m256d ba = _mm256_unpackhi_pd(a, b), dc = _mm256_unpackhi_pd(c, d);
    _mm256_store_pd(to, _mm256_permute2f128_pd(ab, cd, 0x20));
    _mm256_store_pd(to + kTile, _mm256_permute2f128_pd(ba, dc, 0x20));
    _mm256_store_pd(to + 2 * kTile, _mm256_permute2f128_pd(ab, cd, 0x31));
    _mm256_store_pd(to + 3 * kTile, _mm256_permute2f128_pd(ba, dc, 0x31));
  }
  static void transpose(const double (*from)[kTile], double (*to)[kTile]) {
    for (int i = 0; i < kTile; i += 4)
      for (int j = 0; j < kTile; j += 4) transpose_four(&from[i][j], &to[j][i]);
  }
};

class Change {
 public:
  void see(const Row& d, const Row& x) {
    for (int i = 0; i < 4; ++i)
      most_ = _mm256_max_epi32(most_, _mm256_sub_epi32(_mm256_castpd_si256(d.v[i]), _mm256_castpd_si256(x.v[i])));
  }
  std::int32_t most() const {
    alignas(32) std::int32_t lanes[8];
    _mm256_store_si256(reinterpret_cast<__m256i*>(lanes), most_);
    std::int32_t most = INT32_MIN;
    for (int i = 1; i < 8; i += 2) most = lanes[i] > most ? lanes[i] : most;  // the upper halves
    return most;
  }

 private:
  __m256i most_ = _mm256_set1_epi32(INT32_MIN);
};

}  // namespace
}  // namespace meander

#include "planning/tile_kernel_rows.hpp"

namespace meander {
const TileKernel kAvx2TileKernel{"avx2", relax, residual};
}  // namespace meander
#endif

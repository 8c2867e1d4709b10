// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#if defined(__x86_64__)
#include <emmintrin.h>

#include "planning/tile_kernels.hpp"

namespace meander {
namespace {

alignas(16) constexpr std::int64_t kLanes[4][2] = {{0, 0}, {-1, 0}, {0, -1}, {-1, -1}};

struct Row {
  __m128d v[8];

  template <class F>
  static Row each(F f) {
    return {f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)};
  }
  static Row all(double x) {
    return each([&](int) { return _mm_set1_pd(x); });
  }
  static Row load(const double* from) {
    return each([&](int i) { return _mm_load_pd(from + 2 * i); });
  }
  void store(double* to) const {
    for (int i = 0; i < 8; ++i) _mm_store_pd(to + 2 * i, v[i]);
  }
  friend Row operator+(const Row& x, const Row& y) {
    return each([&](int i) { return _mm_add_pd(x.v[i], y.v[i]); });
  }
  friend Row operator-(const Row& x, const Row& y) {
    return each([&](int i) { return _mm_sub_pd(x.v[i], y.v[i]); });
  }
  friend Row operator*(const Row& x, const Row& y) {
    return each([&](int i) { return _mm_mul_pd(x.v[i], y.v[i]); });
  }
  friend Row operator/(const Row& x, const Row& y) {
    return each([&](int i) { return _mm_div_pd(x.v[i], y.v[i]); });
  }
  Row magnitude() const {
    return each([&](int i) { return _mm_andnot_pd(_mm_set1_pd(-0.0), v[i]); });
  }
  Row larger(const Row& y) const {
    return each([&](int i) { return _mm_max_pd(v[i], y.v[i]); });
  }
  Row masked(std::uint32_t mask) const {
    return each([&](int i) {
      return _mm_and_pd(v[i],
                        _mm_castsi128_pd(_mm_load_si128(reinterpret_cast<const __m128i*>(kLanes[mask >> 2 * i & 3]))));
    });
  }
  std::uint32_t above(const Row& y) const {
    int bits = 0;
    for (int i = 0; i < 8; ++i) bits |= _mm_movemask_pd(_mm_cmpgt_pd(v[i], y.v[i])) << 2 * i;
    return static_cast<std::uint32_t>(bits);
  }
  friend Row masked_sum(const Row& x, std::uint32_t of_x, const Row& y, std::uint32_t of_y) {
    return x.masked(of_x) + y.masked(of_y);
  }
  Row from_left(double in) const {
    return each([&](int i) { return _mm_shuffle_pd(i == 0 ? _mm_set1_pd(in) : v[i - 1], v[i], 1); });
  }
  Row from_right(double in) const {
    return each([&](int i) { return _mm_shuffle_pd(v[i], i == 7 ? _mm_set1_pd(in) : v[i + 1], 1); });
  }
  double most() const {
    __m128d most = v[0];
    for (int i = 1; i < 8; ++i) most = _mm_max_pd(most, v[i]);
    return _mm_cvtsd_f64(_mm_max_sd(most, _mm_unpackhi_pd(most, most)));
  }
  static void transpose(const double (*from)[kTile], double (*to)[kTile]) {
    for (int i = 0; i < kTile; i += 2)
      for (int j = 0; j < kTile; j += 2) {
        const __m128d a = _mm_load_pd(&from[i][j]), b = _mm_load_pd(&from[i + 1][j]);
        _mm_store_pd(&to[j][i], _mm_unpacklo_pd(a, b));
        _mm_store_pd(&to[j + 1][i], _mm_unpackhi_pd(a, b));
      }
  }
};

class Change {
 public:
  void see(const Row& d, const Row& x) {
    for (int i = 0; i < 8; ++i) {
      const __m128i seen = _mm_sub_epi32(_mm_castpd_si128(d.v[i]), _mm_castpd_si128(x.v[i]));
      const __m128i more = _mm_cmpgt_epi32(seen, most_);
      most_ = _mm_or_si128(_mm_and_si128(more, seen), _mm_andnot_si128(more, most_));
    }
  }
  std::int32_t most() const {
    alignas(16) std::int32_t lanes[4];
    _mm_store_si128(reinterpret_cast<__m128i*>(lanes), most_);
    return lanes[1] > lanes[3] ? lanes[1] : lanes[3];  // the upper halves
  }

 private:
  __m128i most_ = _mm_set1_epi32(INT32_MIN);
};

}  // namespace
}  // namespace meander

#include "planning/tile_kernel_rows.hpp"

namespace meander {
const TileKernel kSse2TileKernel{"sse2", relax, residual};
}  // namespace meander
#endif

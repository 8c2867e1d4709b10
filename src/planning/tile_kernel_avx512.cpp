// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#if defined(__x86_64__)
#include <immintrin.h>

#include "planning/tile_kernels.hpp"

namespace meander {
namespace {

struct Row {
  __m512d a, b;

  static Row all(double x) { return {_mm512_set1_pd(x), _mm512_set1_pd(x)}; }
  static Row load(const double* from) { return {_mm512_load_pd(from), _mm512_load_pd(from + 8)}; }
  void store(double* to) const { _mm512_store_pd(to, a), _mm512_store_pd(to + 8, b); }
  friend Row operator+(Row x, Row y) { return {_mm512_add_pd(x.a, y.a), _mm512_add_pd(x.b, y.b)}; }
  friend Row operator-(Row x, Row y) { return {_mm512_sub_pd(x.a, y.a), _mm512_sub_pd(x.b, y.b)}; }
  friend Row operator*(Row x, Row y) { return {_mm512_mul_pd(x.a, y.a), _mm512_mul_pd(x.b, y.b)}; }
  friend Row operator/(Row x, Row y) { return {_mm512_div_pd(x.a, y.a), _mm512_div_pd(x.b, y.b)}; }
  Row magnitude() const { return {_mm512_abs_pd(a), _mm512_abs_pd(b)}; }
  Row larger(Row y) const { return {_mm512_max_pd(a, y.a), _mm512_max_pd(b, y.b)}; }
  Row masked(std::uint32_t mask) const {
    return {_mm512_maskz_mov_pd(static_cast<__mmask8>(mask), a),
            _mm512_maskz_mov_pd(static_cast<__mmask8>(mask >> 8), b)};
  }
  std::uint32_t above(Row y) const {
    return static_cast<std::uint32_t>(_mm512_cmp_pd_mask(a, y.a, _CMP_GT_OQ)) |
           static_cast<std::uint32_t>(_mm512_cmp_pd_mask(b, y.b, _CMP_GT_OQ)) << 8;
  }
  friend Row masked_sum(Row x, std::uint32_t of_x, Row y, std::uint32_t of_y) {
    const Row part = x.masked(of_x);
    return {_mm512_mask_add_pd(part.a, static_cast<__mmask8>(of_y), part.a, y.a),
            _mm512_mask_add_pd(part.b, static_cast<__mmask8>(of_y >> 8), part.b, y.b)};
  }
  Row from_left(double in) const { return {shifted<7>(a, _mm512_set1_pd(in)), shifted<7>(b, a)}; }
  Row from_right(double in) const { return {shifted<1>(b, a), shifted<1>(_mm512_set1_pd(in), b)}; }
  double most() const { return _mm512_reduce_max_pd(_mm512_max_pd(a, b)); }

  /// Lanes n .. n + 7 of the 16 in (low, high).
  template <int N>
  static __m512d shifted(__m512d high, __m512d low) {
    return _mm512_castsi512_pd(_mm512_alignr_epi64(_mm512_castpd_si512(high), _mm512_castpd_si512(low), N));
  }
  static void transpose_eight(const double* from, double* to) {
    __m512d r[8], s[8];
    for (int i = 0; i < 8; ++i) r[i] = _mm512_load_pd(from + i * kTile);
    for (int i = 0; i < 8; i += 2)
      s[i] = _mm512_unpacklo_pd(r[i], r[i + 1]), s[i + 1] = _mm512_unpackhi_pd(r[i], r[i + 1]);
    for (int i = 0; i < 8; i += 4)
      for (int j = 0; j < 2; ++j) {
        r[i + j] = _mm512_shuffle_f64x2(s[i + j], s[i + j + 2], 0x88);
        r[i + j + 2] = _mm512_shuffle_f64x2(s[i + j], s[i + j + 2], 0xdd);
      }
    for (int j = 0; j < 4; ++j) {
      _mm512_store_pd(to + j * kTile, _mm512_shuffle_f64x2(r[j], r[j + 4], 0x88));
      _mm512_store_pd(to + (j + 4) * kTile, _mm512_shuffle_f64x2(r[j], r[j + 4], 0xdd));
    }
  }
  static void transpose(const double (*from)[kTile], double (*to)[kTile]) {
    for (int i = 0; i < kTile; i += 8)
      for (int j = 0; j < kTile; j += 8) transpose_eight(&from[i][j], &to[j][i]);
  }
};

class Change {
 public:
  void see(Row d, Row x) {
    most_ = _mm512_max_epi32(most_, _mm512_max_epi32(difference(d.a, x.a), difference(d.b, x.b)));
  }
  std::int32_t most() const { return _mm512_mask_reduce_max_epi32(0xaaaa, most_); }  // the upper halves

 private:
  static __m512i difference(__m512d d, __m512d x) {
    return _mm512_sub_epi32(_mm512_castpd_si512(d), _mm512_castpd_si512(x));
  }
  __m512i most_ = _mm512_set1_epi32(INT32_MIN);
};

}  // namespace
}  // namespace meander

#include "planning/tile_kernel_rows.hpp"

namespace meander {
const TileKernel kAvx512TileKernel{"avx512", relax, residual};
}  // namespace meander
#endif

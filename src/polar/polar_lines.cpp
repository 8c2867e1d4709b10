// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_lines.hpp"

#include "polar/polar_line_sweep.hpp"
#include "polar/polar_ring_solves.hpp"

namespace meander::polar {
namespace {

void sweep_lines_2(const LineSystem& s) { sweep_lines<2>(s); }
void factor_rings_2(const LineSystem& s) { factor_rings<2>(s); }
void solve_rings_2(const LineSystem& s) { solve_rings<2>(s); }
constexpr LineKernels kPortable{"portable", sweep_lines_2, factor_rings_2, solve_rings_2};

#ifdef __x86_64__
// No fused multiply-add: it rounds once where the others round twice.
#define MEANDER_AVX2 [[gnu::target("avx2,no-fma")]]
#define MEANDER_AVX512 [[gnu::target("avx512f,no-fma,prefer-vector-width=512")]]
MEANDER_AVX2 void sweep_lines_4(const LineSystem& s) { sweep_lines<4>(s); }
MEANDER_AVX2 void factor_rings_4(const LineSystem& s) { factor_rings<4>(s); }
MEANDER_AVX2 void solve_rings_4(const LineSystem& s) { solve_rings<4>(s); }
MEANDER_AVX512 void sweep_lines_8(const LineSystem& s) { sweep_lines<8>(s); }
MEANDER_AVX512 void factor_rings_8(const LineSystem& s) { factor_rings<8>(s); }
MEANDER_AVX512 void solve_rings_8(const LineSystem& s) { solve_rings<8>(s); }
constexpr LineKernels kAll[] = {kPortable,
                                {"avx2", sweep_lines_4, factor_rings_4, solve_rings_4},
                                {"avx512", sweep_lines_8, factor_rings_8, solve_rings_8}};

std::size_t usable() {
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2")) return 1;
  return __builtin_cpu_supports("avx512f") ? 3 : 2;
}
#else
constexpr LineKernels kAll[] = {kPortable};
std::size_t usable() { return 1; }
#endif

}  // namespace

std::span<const LineKernels> line_kernels() {
  static const std::size_t count = usable();
  return {kAll, count};
}

}  // namespace meander::polar

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/tile_kernels.hpp"

#include <vector>

namespace meander {

std::span<const TileKernel* const> tile_kernels() {
  static const std::vector<const TileKernel*> kernels = [] {
    std::vector<const TileKernel*> found{&kPortableTileKernel};
#if defined(__x86_64__)
    found.push_back(&kSse2TileKernel);
    if (__builtin_cpu_supports("avx2")) found.push_back(&kAvx2TileKernel);
    if (__builtin_cpu_supports("avx512f")) found.push_back(&kAvx512TileKernel);
#endif
    return found;
  }();
  return kernels;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/area_under_curve.hpp"

#include <algorithm>

namespace meander {

double area_under_curve(std::vector<std::pair<double, bool>> scored) {
  std::sort(scored.begin(), scored.end());
  double pairs = 0, all_true = 0, all_false = 0;
  for (std::size_t i = 0; i < scored.size();) {
    std::size_t end = i;
    double yes = 0, no = 0;
    for (; end < scored.size() && scored[end].first == scored[i].first; ++end) (scored[end].second ? yes : no) += 1;
    pairs += yes * (all_false + 0.5 * no);
    all_true += yes;
    all_false += no;
    i = end;
  }
  return pairs / (all_true * all_false);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/cell_places.hpp"

#include <cmath>

#include "mapping/lanes.hpp"

namespace meander {
namespace {

using mapping::Lanes, mapping::kLanes;

/// Four cells side by side.
struct Four {
  Lanes range, bearing;
};

Four four_places(Lanes x, Lanes y, float heading) {
  const Lanes squares = x * x + y * y;
  Lanes range;
  for (int i = 0; i < kLanes; ++i) range[i] = std::sqrt(squares[i]);
  return {range, mapping::angle(y, x) - heading};
}

}  // namespace

void cell_places(const Vec2& first, double cell, int columns, int rows, double heading, std::span<float> range,
                 std::span<float> bearing) {
  const auto side = static_cast<float>(cell), left = static_cast<float>(first.x());
  const auto turned = static_cast<float>(heading);
  const Lanes steps = Lanes{0, 1, 2, 3} * side;
  std::size_t at = 0;
  for (int row = 0; row < rows; ++row) {
    const Lanes y = mapping::all(static_cast<float>(first.y() + row * cell));
    for (int column = 0; column < columns; column += kLanes) {
      const Four four = four_places(left + static_cast<float>(column) * side + steps, y, turned);
      const int count = columns - column < kLanes ? columns - column : kLanes;
      for (int i = 0; i < count; ++i, ++at) {
        range[at] = four.range[i];
        bearing[at] = four.bearing[i];
      }
    }
  }
}

}  // namespace meander

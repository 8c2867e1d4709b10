// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/lattice.hpp"

#include <array>

namespace meander {
namespace {

constexpr double kSqrt2 = 1.4142135623730951, kSqrt3 = 1.7320508075688772, kSqrt5 = 2.23606797749979;

// A step and its opposite lie side by side: k ^ 1.
constexpr std::array<LatticeStep, 20> kRectangular = {{
    {1, 0, 1},
    {-1, 0, 1},
    {0, 1, 1},
    {0, -1, 1},
    {1, 1, kSqrt2, 2, {{1, 0}, {0, 1}}, true},
    {-1, -1, kSqrt2, 2, {{-1, 0}, {0, -1}}, true},
    {-1, 1, kSqrt2, 2, {{-1, 0}, {0, 1}}, true},
    {1, -1, kSqrt2, 2, {{1, 0}, {0, -1}}, true},
    {2, 0, 2, 1, {{1, 0}}},
    {-2, 0, 2, 1, {{-1, 0}}},
    {0, 2, 2, 1, {{0, 1}}},
    {0, -2, 2, 1, {{0, -1}}},
    {2, 1, kSqrt5, 2, {{1, 0}, {1, 1}}},
    {-2, -1, kSqrt5, 2, {{-1, 0}, {-1, -1}}},
    {1, 2, kSqrt5, 2, {{0, 1}, {1, 1}}},
    {-1, -2, kSqrt5, 2, {{0, -1}, {-1, -1}}},
    {-1, 2, kSqrt5, 2, {{0, 1}, {-1, 1}}},
    {1, -2, kSqrt5, 2, {{0, -1}, {1, -1}}},
    {-2, 1, kSqrt5, 2, {{-1, 0}, {-1, 1}}},
    {2, -1, kSqrt5, 2, {{1, 0}, {1, -1}}},
}};

// Odd rows lie half a cell to the right.
constexpr std::array<LatticeStep, 6> kHexagonalEven = {
    {{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {-1, 1, 1}, {0, -1, 1}}};
constexpr std::array<LatticeStep, 6> kHexagonalOdd = {
    {{1, 0, 1}, {-1, 0, 1}, {1, 1, 1}, {0, -1, 1}, {0, 1, 1}, {1, -1, 1}}};

}  // namespace

std::span<const LatticeStep> lattice_steps(Lattice lattice, int row) {
  if (lattice == Lattice::rectangular) return std::span(kRectangular).first(8);
  if (lattice == Lattice::wide) return kRectangular;
  return (row & 1) != 0 ? kHexagonalOdd : kHexagonalEven;
}

Vec2 cell_center(Lattice lattice, Cell cell) {
  if (lattice != Lattice::hexagonal) return {cell.x + 0.5, cell.y + 0.5};
  return {cell.x + ((cell.y & 1) != 0 ? 1.0 : 0.5), (cell.y + 0.5) * kSqrt3 / 2};
}

Cell cell_at(Lattice lattice, const Vec2& place) {
  const Vec2 point = place.cwiseMax(-GridFrame::kFarthestCell).cwiseMin(GridFrame::kFarthestCell);
  if (lattice != Lattice::hexagonal)
    return {static_cast<int>(std::floor(point.x())), static_cast<int>(std::floor(point.y()))};
  const int row = static_cast<int>(std::floor(point.y() * 2 / kSqrt3));
  Cell best{};
  double least = std::numeric_limits<double>::infinity();
  for (int y = row - 1; y <= row + 1; ++y) {
    const Cell cell{static_cast<int>(std::floor(point.x() - ((y & 1) != 0 ? 0.5 : 0.0))), y};
    const double distance = (cell_center(lattice, cell) - point).squaredNorm();
    if (distance < least) least = distance, best = cell;
  }
  return best;
}

bool open_step(const Grid<std::uint8_t>& blocked, Corners corners, Cell from, const LatticeStep& step) {
  if (blocked.at({from.x + step.dx, from.y + step.dy}, 1) != 0) return false;
  if (step.diagonal && corners == Corners::cut) return true;
  for (int i = 0; i < step.vias; ++i)
    if (blocked.at({from.x + step.via[i].x, from.y + step.via[i].y}, 1) != 0) return false;
  return true;
}

}  // namespace meander

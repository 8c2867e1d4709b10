// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>

#include "base/fields.hpp"
#include "grid/grid.hpp"

namespace meander {

/// How the units lie and which of them are neighbours. rectangular: the 8 around (r = 1.5); wide: the 20 nearer than
/// r = 2.5; hexagonal: 6, with odd rows half a cell to the right and rows sqrt(3)/2 apart.
enum class Lattice { rectangular, wide, hexagonal };
template <>
struct EnumNames<Lattice> {
  static constexpr std::pair<Lattice, const char*> entries[] = {
      {Lattice::rectangular, "rectangular"}, {Lattice::wide, "wide"}, {Lattice::hexagonal, "hexagonal"}};
};

/// May a diagonal step pass between cells of which one is blocked, or both? keep: both must be free; cut: it may.
enum class Corners { keep, cut };
template <>
struct EnumNames<Corners> {
  static constexpr std::pair<Corners, const char*> entries[] = {{Corners::keep, "keep"}, {Corners::cut, "cut"}};
};

/// From a cell to a neighbour.
struct LatticeStep {
  int dx = 0;
  int dy = 0;
  double length = 1;      ///< rho [cells]
  int vias = 0;           ///< cells beside or below the way ...
  Cell via[2] = {};       ///< ... relative to the first
  bool diagonal = false;  ///< Corners decides about the vias; those of longer steps must always be free
};

/// The steps that leave a cell of this row, always in the same order: step k and step k ^ 1 of the cell it leads to are
/// opposite.
std::span<const LatticeStep> lattice_steps(Lattice lattice, int row = 0);

/// Where the cell's centre lies, in units of cells from the lower left corner of the grid.
Vec2 cell_center(Lattice lattice, Cell cell);
/// The cell whose centre is nearest.
Cell cell_at(Lattice lattice, const Vec2& point);

/// Is the step allowed as far as free and blocked cells go? `from` is taken to be free.
bool open_step(const Grid<std::uint8_t>& blocked, Corners corners, Cell from, const LatticeStep& step);

}  // namespace meander

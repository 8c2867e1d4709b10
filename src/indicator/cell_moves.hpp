// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once

namespace meander {

/// Lengths of steps from cell to cell, in fifths of a cell: whole numbers, 1 % off the square root of 2.
inline constexpr int kStraight = 5, kDiagonal = 7;

struct CellMove {
  int dx, dy, length;
};
inline constexpr CellMove kCellMoves[] = {{1, 0, kStraight},   {0, 1, kStraight}, {-1, 0, kStraight},
                                          {0, -1, kStraight},  {1, 1, kDiagonal}, {-1, 1, kDiagonal},
                                          {-1, -1, kDiagonal}, {1, -1, kDiagonal}};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <span>

#include "geometry/material_table.hpp"
#include "geometry/shape_grid.hpp"
#include "geometry/shape_index.hpp"

namespace meander {

/// Who owns which pieces, and the grid of cells over them.
struct ShapeIndex::State {
  struct Owner {
    bool present = false;
    bool round = false;  ///< a disc: one pole instead of walls
    std::uint32_t material = 0;
    PoolRun walls;
    Disc disc;
    Box box;
  };
  static constexpr std::size_t kEditsKept = 64;

  explicit State(double cell);

  void insert(std::uint32_t slot, const Shape& shape, const Material& material);
  void remove(std::uint32_t slot);
  std::span<const Wall> walls_of(const Owner& owner) const { return walls.items(owner.walls); }

  double finest;  ///< side of the cells while memory allows [m]
  std::vector<Owner> owners;
  RunPool<Wall> walls;
  std::size_t present = 0;
  std::size_t wall_count = 0;
  ShapeGrid grid;
  MaterialTable materials;
  std::uint64_t revision = 0;
  std::array<Box, kEditsKept> edits;  ///< what the last edits changed; edit number n is at n % kEditsKept

 private:
  double entries(double side) const;
  bool affordable(double side) const;
  CellFrame suitable_frame() const;
  void rebuild();
  void measure(const Owner& owner, int sign);
  void put(std::uint32_t slot, int sign);

  double length_ = 0;  ///< of all walls along x plus along y [m]: says how many cells they touch
  double area_ = 0;    ///< of all poles' boxes [m2]
  std::vector<Wall> scratch_;
};

}  // namespace meander

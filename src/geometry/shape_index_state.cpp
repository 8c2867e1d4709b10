// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_index_state.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "geometry/shape_pieces.hpp"

namespace meander {
namespace {

/// Bounds on memory: worlds that are wider or have longer walls than this get coarser cells.
constexpr double kMostCells = 1 << 20;
constexpr double kMostAlong = 1 << 14;    ///< cells along one side of the grid
constexpr double kMostEntries = 1 << 20;  ///< pieces in cells, besides kEntriesPerWall for every wall
constexpr double kEntriesPerWall = 8;

Box box_of(std::span<const Wall> walls) {
  Box box{walls.front().a, walls.front().a};
  for (const Wall& wall : walls) {
    box.low = box.low.cwiseMin(wall.a).cwiseMin(wall.b);
    box.high = box.high.cwiseMax(wall.a).cwiseMax(wall.b);
  }
  return box;
}

}  // namespace

ShapeIndex::State::State(double cell)
    : finest(std::exp2(std::round(std::log2(cell)))), grid(CellFrame{finest, {0, 0}, 3, 3}) {}

void ShapeIndex::State::insert(std::uint32_t slot, const Shape& shape, const Material& material) {
  if (slot >= owners.size()) owners.resize(slot + 1);
  Owner& owner = owners[slot];
  if (owner.present) fail("shape index: owner {} already has a shape", slot);
  owner.material = materials.take(material);
  owner.present = true;
  const Disc* disc = std::get_if<Disc>(&shape);
  owner.round = disc != nullptr;
  if (disc) owner.disc = *disc;
  scratch_.clear();
  append_walls(shape, scratch_);
  owner.box = disc ? bounding_box(shape) : box_of(scratch_);
  walls.resize(owner.walls, static_cast<std::uint32_t>(scratch_.size()));
  Wall* wall = walls.begin(owner.walls);
  for (const Wall& w : scratch_) *wall = w, wall->owner = slot, wall->material = owner.material, ++wall;
  ++present;
  measure(owner, 1);
  if (grid.frame().holds(owner.box) && affordable(grid.frame().side))
    put(slot, 1);
  else
    rebuild();
  edits[revision++ % kEditsKept] = owner.box;
}

void ShapeIndex::State::remove(std::uint32_t slot) {
  if (slot >= owners.size() || !owners[slot].present) fail("shape index: owner {} has no shape", slot);
  Owner& owner = owners[slot];
  put(slot, -1);
  measure(owner, -1);
  walls.resize(owner.walls, 0);
  materials.release(owner.material);
  owner.present = false;
  --present;
  if (grid.frame().side > finest && present > 0 && suitable_frame().side < grid.frame().side) rebuild();
  edits[revision++ % kEditsKept] = owner.box;
}

double ShapeIndex::State::entries(double side) const {
  return length_ / side + area_ / (side * side) + 2.0 * static_cast<double>(wall_count);
}

bool ShapeIndex::State::affordable(double side) const {
  return entries(side) <= kMostEntries + kEntriesPerWall * static_cast<double>(wall_count);
}

/// The finest cells within the bounds on memory, a quarter more of them than needed to every side.
CellFrame ShapeIndex::State::suitable_frame() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Owner& owner : owners)
    if (owner.present) box = {box.low.cwiseMin(owner.box.low), box.high.cwiseMax(owner.box.high)};
  const double margin = 0.25 * box.size().maxCoeff();
  for (double side = finest;; side *= 2) {
    const double reach = margin + 2 * side;
    const Vec2 low = ((box.low.array() - reach) / side).floor(), high = ((box.high.array() + reach) / side).ceil();
    const Vec2 count = high - low;
    if (count.maxCoeff() > kMostAlong || count.prod() > kMostCells || !affordable(side)) continue;
    return {side, side * low, static_cast<int>(count.x()), static_cast<int>(count.y())};
  }
}

void ShapeIndex::State::rebuild() {
  grid = ShapeGrid(suitable_frame());
  for (std::uint32_t slot = 0; slot < owners.size(); ++slot)
    if (owners[slot].present) put(slot, 1);
}

void ShapeIndex::State::measure(const Owner& owner, int sign) {
  for (const Wall& wall : walls_of(owner)) length_ += sign * (wall.b - wall.a).lpNorm<1>();
  if (owner.round) area_ += sign * 4 * owner.disc.radius * owner.disc.radius;
  wall_count = sign > 0 ? wall_count + owner.walls.count : wall_count - owner.walls.count;
}

void ShapeIndex::State::put(std::uint32_t slot, int sign) {
  const Owner& owner = owners[slot];
  const Pole pole{owner.disc, slot, owner.material};
  if (owner.round) sign > 0 ? grid.add(pole) : grid.remove(pole);
  std::uint32_t id = owner.walls.first;
  for (const Wall& wall : walls_of(owner)) sign > 0 ? grid.add(wall, id++) : grid.remove(wall, id++);
  if (owner.walls.count > 0 && walls_of(owner)[0].solid) grid.cover(walls_of(owner), owner.box, sign);
}

}  // namespace meander

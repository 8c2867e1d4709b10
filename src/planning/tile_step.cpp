// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/tile_step.hpp"

#include <bit>
#include <cmath>
#include <cstring>

namespace meander {
namespace {

using Side = TileScratch::Side;

constexpr std::int32_t kBlock = 512;  ///< exponents are multiples of this
constexpr double kHigh = 0x1p440, kLow = 0x1p-100;
constexpr int kPatience = 4;  ///< bits of -log2 v that a bit of -log2 of a change is worth
constexpr int kCoarse = 3;    ///< units that are within 2^3 bits come together
constexpr std::uint8_t kAllSides = 0xf;

struct AllLinks {
  std::uint32_t links[kTile + 1];
  constexpr AllLinks() : links() {
    for (std::uint32_t& l : links) l = 0x1ffff;
  }
};
constexpr AllLinks kAllLinks;

constexpr Side opposite(int side) { return static_cast<Side>(side ^ 1); }

/// The activation along one side of a tile.
const double* line_of(const TileCells& cells, int side) {
  switch (side) {
    case Side::below:
      return cells.cell[0];
    case Side::above:
      return cells.cell[kTile - 1];
    case Side::left:
      return cells.side[0];
    default:
      return cells.side[1];
  }
}

template <class Visit>
void for_each_bit(std::uint32_t bits, Visit visit) {
  for (; bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
}

int bits_of(double x) { return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) - 1023; }

/// Large activation first; small corrections wait, so that several become one. [LM99+] In the order of activation
/// alone a unit would be taken up three times as often.
std::int32_t urgency(std::int32_t exponent, double value, int change_bits) {
  return (-(exponent + bits_of(value)) - kPatience * change_bits) >> kCoarse;
}

/// 2^(512 blocks), for blocks that are near to each other.
double block_factor(std::int32_t blocks) {
  return blocks == 0 ? 1 : blocks == 1 ? 0x1p512 : blocks == -1 ? 0x1p-512 : 0;
}

}  // namespace

/// Multiplies the unit's numbers by 2^(-512 blocks); what it means stays.
void TileStep::scale(TileUnit& unit, int blocks) const {
  const double factor = block_factor(-blocks);
  unit.exponent += kBlock * blocks;
  TileCells& cells = map.cells_of(unit.slot);
  for (int r = 0; r < kTile; ++r) {
    for_each_bit(unit.rows[static_cast<std::size_t>(r)], [&](int x) { cells.cell[r][x] *= factor; });
    cells.side[0][r] = cells.cell[r][0];
    cells.side[1][r] = cells.cell[r][kTile - 1];
  }
}

void TileStep::rebase(TileUnit& unit) const {
  if (unit.exponent != 0) scale(unit, -unit.exponent / kBlock);
}

/// What the other unit's numbers, of which `value` is the highest that matters, are to be multiplied with in our block.
double TileStep::factor_of(const TileUnit& unit, const TileUnit& other, double value, Above& above) const {
  const std::int32_t blocks = (other.exponent - unit.exponent) / kBlock;
  above.blocks = std::max(above.blocks, blocks);
  if (blocks == 1) above.highest = std::max(above.highest, value * 0x1p512);
  return block_factor(blocks);
}

/// Where the activation beyond the side stands: in place, or in `brought`.
const double* TileStep::gather_edge(const TileUnit& unit, int side, double* brought, Above& above) const {
  const std::int32_t slot = map.slot_beside(unit.slot, side);
  const double* edge = line_of(map.cells_of(slot), opposite(side));
  map.for_each_unit(slot, [&](std::int32_t, const TileUnit& other) {
    if (other.exponent == unit.exponent || other.exponent == TileUnit::kAsleep) return;
    if (edge != brought) edge = static_cast<const double*>(std::memcpy(brought, edge, kTile * sizeof(double)));
    const std::uint32_t bits = edge_bits(other, opposite(side));
    if (bits_across(map, unit, side, other) == 0) return for_each_bit(bits, [&](int i) { brought[i] = 0; });
    double highest = 0;
    for_each_bit(bits, [&](int i) { highest = std::max(highest, brought[i]); });
    if (highest == 0) return;  // it was woken up, but has nothing to say yet
    const double factor = factor_of(unit, other, highest, above);
    for_each_bit(bits, [&](int i) { brought[i] *= factor; });
  });
  return edge;
}

double TileStep::gather_corner(const TileUnit& unit, int c, Above& above) const {
  if (!corner_open(map, unit, c)) return 0;
  const std::int32_t slot = map.slot_at_corner(unit.slot, c);
  const int x = (c & 1) != 0 ? 0 : kTile - 1, y = (c & 2) != 0 ? 0 : kTile - 1;
  const double value = map.cells_of(slot).cell[y][x];
  if (value == 0) return 0;
  const TileUnit& other = map.units[static_cast<std::size_t>(map.unit_at(slot, x, y))];
  return other.exponent == unit.exponent ? value : value * factor_of(unit, other, value, above);
}

/// False: the neighbours are so much higher that the unit was brought to their exponent.
bool TileStep::gather_surroundings(TileUnit& unit, TileScratch& scratch) const {
  Above above;
  for (int side = 0; side < 4; ++side) scratch.edge[side] = gather_edge(unit, side, scratch.brought[side], above);
  for (int c = 0; c < 4; ++c) scratch.corner[c] = gather_corner(unit, c, above);
  if (above.blocks <= 1 && above.highest < kHigh) return true;
  scale(unit, above.blocks);
  return false;
}

void TileStep::gather(TileUnit& unit, TileScratch& scratch) const {
  while (!gather_surroundings(unit, scratch)) {
  }
  const auto slot = static_cast<std::size_t>(unit.slot);
  scratch.home = &map.cells_of(unit.slot);
  scratch.shared = map.units_in[slot].end - map.units_in[slot].first > 1;
  scratch.full = unit.full;
  scratch.fresh = unit.fresh;
  scratch.open[0] = unit.rows.data();
  scratch.open[1] = unit.columns.data();
  scratch.across = unit.across.data();
  scratch.gain = scratch.hold = nullptr;
  scratch.links[0] = scratch.links[1] = unit.curve >= 0 ? kAllLinks.links : nullptr;
  if (unit.links >= 0) {
    const TileMap::Links& links = map.links[static_cast<std::size_t>(unit.links)];
    scratch.links[0] = links.rows.data();
    scratch.links[1] = links.columns.data();
  }
  if (unit.curve < 0) return;
  const TileCurve& curve = curves[static_cast<std::size_t>(unit.curve)];
  scratch.gain = curve.gain;
  scratch.hold = curve.hold;
}

/// The gains of the activation that was reached: at the equilibrium v = gain u and gain = tanh(u) / u.
void TileStep::bend(TileUnit& unit, const TileScratch& scratch) const {
  TileCurve& curve = curves[static_cast<std::size_t>(unit.curve)];
  for (int r = 0; r < kTile; ++r)
    for (int x = 0; x < kTile; ++x) {
      double& gain = curve.gain[r][x];
      if (gain == 0) continue;
      const double u = scratch.cell[r][x] / gain, q = u * u;
      gain = (135135 + q * (17325 + q * (378 + q))) / (135135 + q * (62370 + q * (3150 + q * 28)));  // see squash()
    }
}

void TileStep::relax(std::int32_t number, double threshold, TileScratch& scratch, TileOutcome& outcome) const {
  TileUnit& unit = map.units[static_cast<std::size_t>(number)];
  gather(unit, scratch);
  scratch.sweep_rows = (unit.sides & 3) != 0;
  scratch.sweep_columns = (unit.sides & 12) != 0;
  unit.sides = 0;
  unit.fresh = false;
  scratch.keep = 1 - omega;
  scratch.straight = omega * beta;
  scratch.slant = scratch.straight * kRootHalf;
  scratch.beta = beta;
  scratch.threshold = threshold;
  kernel.relax(scratch);
  outcome.relaxations += std::int64_t{unit.size} * 2 * (scratch.sweep_rows + scratch.sweep_columns);
  const bool curved = unit.curve >= 0;
  if (curved) bend(unit, scratch);

  for (int side = 0; side < 4; ++side) tell_side(unit, side, scratch, outcome);
  for (int c = 0; c < 4; ++c) tell_corner(unit, c, scratch, outcome);
  const double highest = scratch.highest;
  const int change_bits = scratch.change >> 20;
  if (highest > 0 && change_bits >= bits_of(threshold)) tell(unit, number, highest, change_bits, kAllSides, outcome);
  if (!curved && highest == 0) unit.exponent = TileUnit::kAsleep;  // what was told it came to nothing
  if (!curved && highest > 0 && highest < kLow) scale(unit, -1);
}

void TileStep::tell(const TileUnit& unit, std::int32_t other, double value, int change_bits, int sides,
                    TileOutcome& outcome) const {
  const bool steep = unit.exponent == 0 && value > bent_above;
  outcome.add({other, urgency(unit.exponent, value, change_bits), static_cast<std::uint8_t>(sides), steep,
               unit.exponent - (value < kLow ? kBlock : 0)});
}

void TileStep::tell_side(const TileUnit& unit, int side, const TileScratch& scratch, TileOutcome& outcome) const {
  const TileScratch::Told& told = scratch.told[side];
  if (told.cells == 0) return;
  map.for_each_unit(map.slot_beside(unit.slot, side), [&](std::int32_t u, const TileUnit& other) {
    if ((edge_bits(other, opposite(side)) & told.cells) != 0)
      tell(unit, u, told.highest, told.share >> 20, 1 << opposite(side), outcome);
  });
}

void TileStep::tell_corner(const TileUnit& unit, int c, const TileScratch& scratch, TileOutcome& outcome) const {
  const bool right = (c & 1) != 0, up = (c & 2) != 0;
  const int side = up ? Side::above : Side::below, lane = right ? kTile - 1 : 0;
  const double now = scratch.now[side][lane], change = std::abs(now - scratch.old[side][lane]);
  const double felt = beta * kRootHalf * change, have = std::max(scratch.corner[c], beta * kRootHalf * now);
  if (!(felt > scratch.threshold * have) || !corner_open(map, unit, c)) return;
  const std::int32_t other = map.unit_at(map.slot_at_corner(unit.slot, c), right ? 0 : kTile - 1, up ? 0 : kTile - 1);
  if (other < 0) return;
  tell(unit, other, now, bits_of(felt / have),
       1 << (up ? Side::below : Side::above) | 1 << (right ? Side::left : Side::right), outcome);
}

double TileStep::highest_of(const TileUnit& unit) const {
  const TileCells& cells = map.cells_of(unit.slot);
  double highest = 0;
  for (int r = 0; r < kTile; ++r)
    for_each_bit(unit.rows[static_cast<std::size_t>(r)], [&](int x) { highest = std::max(highest, cells.cell[r][x]); });
  return highest;
}

std::int32_t TileStep::place(std::int32_t number) const {
  const TileUnit& unit = map.units[static_cast<std::size_t>(number)];
  return urgency(unit.exponent, highest_of(unit), 0);
}

bool TileStep::is_steep(const TileUnit& unit) const { return unit.exponent == 0 && highest_of(unit) > bent_above; }

double TileStep::residual(std::int32_t number, TileScratch& scratch) const {
  TileUnit& unit = map.units[static_cast<std::size_t>(number)];
  gather(unit, scratch);
  scratch.straight = beta;
  scratch.slant = beta * kRootHalf;
  return kernel.residual(scratch);
}

}  // namespace meander

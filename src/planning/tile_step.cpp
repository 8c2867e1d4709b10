// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/tile_step.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

namespace meander {
namespace {

using Side = TileScratch::Side;

constexpr std::int32_t kBlock = 512;  ///< exponents are multiples of this
constexpr double kHigh = 0x1p440, kLow = 0x1p-100;
constexpr double kBend = 2e-4;  ///< below, tanh(u) = u to within 2e-8 of itself
constexpr int kPatience = 4;    ///< bits of -log2 v that a bit of -log2 of a change is worth
constexpr int kCoarse = 3;      ///< units that are within 2^3 bits come together
constexpr std::uint8_t kAllSides = 0xf;
constexpr double kRootHalf = std::numbers::sqrt2 / 2;

struct AllLinks {
  std::uint32_t links[kTile + 1];
  constexpr AllLinks() : links() {
    for (std::uint32_t& l : links) l = 0x1ffff;
  }
};
constexpr AllLinks kAllLinks;

constexpr Side opposite(int side) { return static_cast<Side>(side ^ 1); }

std::int32_t step_to(const TileMap& map, int side) {
  const std::int32_t steps[4] = {-map.across, map.across, -1, 1};
  return steps[side];
}

std::int32_t corner_step(const TileMap& map, int c) {
  return ((c & 2) != 0 ? map.across : -map.across) + ((c & 1) != 0 ? 1 : -1);
}

/// The unit's cells along one of its sides.
std::uint32_t edge_bits(const TileUnit& unit, int side) {
  switch (side) {
    case Side::below:
      return unit.rows.front();
    case Side::above:
      return unit.rows.back();
    case Side::left:
      return unit.columns.front();
    default:
      return unit.columns.back();
  }
}

/// The cells of `other`, across the side, if any is connected with one of the unit. Where corners are kept every
/// diagonal connection has a straight one beside it.
std::uint32_t bits_across(const TileMap& map, const TileUnit& unit, int side, const TileUnit& other) {
  const std::uint32_t own = edge_bits(unit, side), bits = edge_bits(other, opposite(side));
  const std::uint32_t reach = map.corners == Corners::cut ? own | own << 1 | own >> 1 : own;
  return (reach & bits) != 0 ? bits : 0;
}

/// Is the unit's cell in corner c connected with the tile across? Bit 0 of c: right, bit 1: above.
bool corner_open(const TileMap& map, const TileUnit& unit, int c) {
  const bool right = (c & 1) != 0, up = (c & 2) != 0;
  if ((unit.rows[up ? kTile - 1 : 0] >> (right ? kTile - 1 : 0) & 1) == 0) return false;
  return unit.links < 0 ||
         (map.links[static_cast<std::size_t>(unit.links)].rows[up ? kTile : 0] >> (right ? kTile : 0) & 1) != 0;
}

/// The activation along one side of a slot.
const double* edge_values(TileMap& map, std::int32_t slot, int side) {
  switch (side) {
    case Side::below:
      return map.cells_of(slot);
    case Side::above:
      return map.cells_of(slot) + kTile * (kTile - 1);
    case Side::left:
      return map.sides_of(slot);
    default:
      return map.sides_of(slot) + kTile;
  }
}

template <class Visit>
void for_each_unit(TileMap& map, std::int32_t slot, Visit visit) {
  const std::int32_t end = map.first_unit[static_cast<std::size_t>(slot) + 1];
  for (std::int32_t u = map.first_unit[static_cast<std::size_t>(slot)]; u < end; ++u)
    visit(u, map.units[static_cast<std::size_t>(u)]);
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

/// 2^(512 blocks) for neighbours whose block is other than ours.
double block_factor(std::int32_t blocks) {
  return blocks == 0 ? 1 : blocks == 1 ? 0x1p512 : blocks == -1 ? 0x1p-512 : 0;
}

}  // namespace

/// Multiplies the unit's numbers by 2^(-512 blocks); what it means stays.
void TileStep::scale(TileUnit& unit, int blocks) const {
  const double factor = block_factor(-blocks);
  unit.exponent += kBlock * blocks;
  double* cells = map.cells_of(unit.slot);
  double* sides = map.sides_of(unit.slot);
  for (int r = 0; r < kTile; ++r) {
    for_each_bit(unit.rows[static_cast<std::size_t>(r)], [&](int x) { cells[r * kTile + x] *= factor; });
    sides[r] = cells[r * kTile];
    sides[kTile + r] = cells[r * kTile + kTile - 1];
  }
}

/// What the other unit's numbers, of which `value` is the highest that matters, are to be multiplied with in our block.
double TileStep::brought(const TileUnit& unit, const TileUnit& other, double value, Above& above) const {
  const std::int32_t blocks = (other.exponent - unit.exponent) / kBlock;
  above.blocks = std::max(above.blocks, blocks);
  if (blocks == 1) above.highest = std::max(above.highest, value * 0x1p512);
  return block_factor(blocks);
}

void TileStep::gather_edge(const TileUnit& unit, int side, double* edge, Above& above) const {
  const std::int32_t t = map.tile[static_cast<std::size_t>(unit.slot)];
  const std::int32_t slot = map.slot[static_cast<std::size_t>(t + step_to(map, side))];
  std::memcpy(edge, edge_values(map, slot, opposite(side)), kTile * sizeof(double));
  for_each_unit(map, slot, [&](std::int32_t, const TileUnit& other) {
    if (other.exponent == unit.exponent) return;
    const std::uint32_t bits = edge_bits(other, opposite(side));
    if (bits_across(map, unit, side, other) == 0) return for_each_bit(bits, [&](int i) { edge[i] = 0; });
    double highest = 0;
    for_each_bit(bits, [&](int i) { highest = std::max(highest, edge[i]); });
    if (highest == 0) return;  // it was woken up, but has nothing to say yet
    const double factor = brought(unit, other, highest, above);
    for_each_bit(bits, [&](int i) { edge[i] *= factor; });
  });
}

double TileStep::gather_corner(const TileUnit& unit, int c, Above& above) const {
  if (!corner_open(map, unit, c)) return 0;
  const std::int32_t t = map.tile[static_cast<std::size_t>(unit.slot)];
  const std::int32_t slot = map.slot[static_cast<std::size_t>(t + corner_step(map, c))];
  const int x = (c & 1) != 0 ? 0 : kTile - 1, y = (c & 2) != 0 ? 0 : kTile - 1;
  const double value = map.cells_of(slot)[y * kTile + x];
  if (value == 0) return 0;
  const TileUnit& other = map.units[static_cast<std::size_t>(map.unit_at(slot, x, y))];
  return other.exponent == unit.exponent ? value : value * brought(unit, other, value, above);
}

/// False: the neighbours are so much higher that the unit was brought to their exponent.
bool TileStep::gather_surroundings(TileUnit& unit, TileScratch& scratch) const {
  Above above;
  for (int side = 0; side < 4; ++side) gather_edge(unit, side, scratch.edge[side], above);
  for (int c = 0; c < 4; ++c) scratch.corner[c] = gather_corner(unit, c, above);
  if (above.blocks <= 1 && above.highest < kHigh) return true;
  scale(unit, above.blocks);
  return false;
}

void TileStep::gather(TileUnit& unit, TileScratch& scratch) const {
  while (!gather_surroundings(unit, scratch)) {
  }
  std::memcpy(scratch.cell, map.cells_of(unit.slot), sizeof scratch.cell);
  const auto slot = static_cast<std::size_t>(unit.slot);
  scratch.shared = map.first_unit[slot + 1] - map.first_unit[slot] > 1;
  scratch.full = unit.full;
  scratch.curved = unit.curve >= 0;
  std::memcpy(scratch.open[0], unit.rows.data(), sizeof scratch.open[0]);
  std::memcpy(scratch.open[1], unit.columns.data(), sizeof scratch.open[1]);
  scratch.links[0] = scratch.links[1] = scratch.curved ? kAllLinks.links : nullptr;
  if (unit.links >= 0) {
    const TileMap::Links& links = map.links[static_cast<std::size_t>(unit.links)];
    scratch.links[0] = links.rows.data();
    scratch.links[1] = links.columns.data();
  }
  if (!scratch.curved) return;
  const TileCurve& curve = curves[static_cast<std::size_t>(unit.curve)];
  std::memcpy(scratch.gain, curve.gain, sizeof scratch.gain);
  std::memcpy(scratch.hold, curve.hold, sizeof scratch.hold);
}

void TileStep::store(TileUnit& unit, TileScratch& scratch) const {
  double* cells = map.cells_of(unit.slot);
  double* sides = map.sides_of(unit.slot);
  if (scratch.shared)
    for (int r = 0; r < kTile; ++r)
      for (int x = 0; x < kTile; ++x) cells[r * kTile + x] = scratch.cell[r][x] + scratch.others[r][x];
  else
    std::memcpy(cells, scratch.cell, sizeof scratch.cell);
  for (int r = 0; r < kTile; ++r) sides[r] = cells[r * kTile], sides[kTile + r] = cells[r * kTile + kTile - 1];
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
  scratch.keep = 1 - omega;
  scratch.straight = omega * beta;
  scratch.slant = scratch.straight * kRootHalf;
  std::array<TileEdge, 4> edges;
  for (int side = 0; side < 4; ++side) note_old(unit, side, scratch, edges[static_cast<std::size_t>(side)]);
  unit.fresh = false;
  kernel.relax(scratch);
  outcome.relaxations += std::int64_t{unit.size} * 2 * (scratch.sweep_rows + scratch.sweep_columns);
  store(unit, scratch);
  if (scratch.curved) bend(unit, scratch);

  double highest = 0;
  for (int side = 0; side < 4; ++side)
    highest =
        std::max(highest, tell_side(unit, side, threshold, scratch, edges[static_cast<std::size_t>(side)], outcome));
  tell_corners(unit, threshold, scratch, edges, outcome);
  const int change_bits = scratch.change >> 20;
  if (highest > 0 && change_bits >= bits_of(threshold)) tell(unit, number, highest, change_bits, kAllSides, outcome);
  if (!scratch.curved && highest == 0) unit.exponent = TileUnit::kAsleep;  // what was told it came to nothing
  if (!scratch.curved && highest > 0 && highest < kLow) scale(unit, -1);
}

/// The unit's activation along a side, before.
void TileStep::note_old(const TileUnit& unit, int side, const TileScratch& scratch, TileEdge& edge) const {
  std::memcpy(edge.old, edge_values(map, unit.slot, side), sizeof edge.old);
  if (unit.fresh) std::memset(edge.old, 0, sizeof edge.old);
  if (!scratch.shared) return;
  for (int i = 0; i < kTile; ++i)
    if ((edge_bits(unit, side) >> i & 1) == 0) edge.old[i] = 0;
}

void TileStep::tell(const TileUnit& unit, std::int32_t other, double value, int change_bits, int sides,
                    TileOutcome& outcome) const {
  const bool steep = unit.exponent == 0 && value > kBend;
  outcome.add({other, urgency(unit.exponent, value, change_bits), static_cast<std::uint8_t>(sides), steep,
               unit.exponent - (value < kLow ? kBlock : 0)});
}

/// Returns the highest activation along the side.
double TileStep::tell_side(const TileUnit& unit, int side, double threshold, const TileScratch& scratch, TileEdge& edge,
                           TileOutcome& outcome) const {
  if (side < 2)
    std::memcpy(edge.now, scratch.cell[side == Side::below ? 0 : kTile - 1], sizeof edge.now);
  else
    for (int r = 0; r < kTile; ++r) edge.now[r] = scratch.cell[r][side == Side::left ? 0 : kTile - 1];
  const std::int32_t t = map.tile[static_cast<std::size_t>(unit.slot)];
  const std::int32_t slot = map.slot[static_cast<std::size_t>(t + step_to(map, side))];
  edge.open = 0;
  for_each_unit(map, slot,
                [&](std::int32_t, const TileUnit& other) { edge.open |= bits_across(map, unit, side, other); });
  std::memcpy(edge.across, scratch.edge[side], sizeof edge.across);
  edge.straight = beta;
  edge.slant = beta * kRootHalf;
  kernel.effect(edge);
  if (!(edge.most_share > threshold)) return edge.most_now;
  for_each_unit(map, slot, [&](std::int32_t u, const TileUnit& other) {
    double share = 0;
    for_each_bit(bits_across(map, unit, side, other), [&](int i) { share = std::max(share, edge.share[i]); });
    if (share > threshold) tell(unit, u, edge.most_now, bits_of(share), 1 << opposite(side), outcome);
  });
  return edge.most_now;
}

void TileStep::tell_corners(const TileUnit& unit, double threshold, const TileScratch& scratch,
                            const std::array<TileEdge, 4>& edges, TileOutcome& outcome) const {
  const std::int32_t t = map.tile[static_cast<std::size_t>(unit.slot)];
  for (int c = 0; c < 4; ++c) {
    const bool right = (c & 1) != 0, up = (c & 2) != 0;
    const double now = scratch.cell[up ? kTile - 1 : 0][right ? kTile - 1 : 0];
    const double change = std::abs(now - edges[up ? 1 : 0].old[right ? kTile - 1 : 0]);
    if (change == 0 || !corner_open(map, unit, c)) continue;
    const std::int32_t slot = map.slot[static_cast<std::size_t>(t + corner_step(map, c))];
    const std::int32_t other = map.unit_at(slot, right ? 0 : kTile - 1, up ? 0 : kTile - 1);
    if (other < 0) continue;
    const double share = beta * kRootHalf * change / std::max(scratch.corner[c], beta * kRootHalf * now);
    if (share > threshold)
      tell(unit, other, now, bits_of(share),
           1 << (up ? Side::below : Side::above) | 1 << (right ? Side::left : Side::right), outcome);
  }
}

std::int32_t TileStep::place(std::int32_t number) const {
  const TileUnit& unit = map.units[static_cast<std::size_t>(number)];
  const double* cells = map.cells_of(unit.slot);
  double highest = 0;
  for (int r = 0; r < kTile; ++r)
    for_each_bit(unit.rows[static_cast<std::size_t>(r)],
                 [&](int x) { highest = std::max(highest, cells[r * kTile + x]); });
  return urgency(unit.exponent, highest, 0);
}

double TileStep::residual(std::int32_t number, TileScratch& scratch) const {
  TileUnit& unit = map.units[static_cast<std::size_t>(number)];
  gather(unit, scratch);
  scratch.straight = beta;
  scratch.slant = beta * kRootHalf;
  return kernel.residual(scratch);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What every tile kernel does, written once over `Row`: 16 doubles in the registers of one processor, with element-wise
// arithmetic, masks, shifts by one and a transposition. Included once by each kernel's file after its Row, which is
// why all this has internal linkage. The order of the operations is fixed and no two are fused: same bits everywhere.
#pragma once
#include "planning/tile_kernel.hpp"

namespace meander {
namespace {

/// The tile as a pass sees it: rows as they are, or its columns.
struct Pass {
  double (*cell)[kTile];
  const double (*gain)[kTile];
  const double (*hold)[kTile];
  const double *first, *last, *left, *right;  ///< neighbours outside
  double corner[4];
  const std::uint16_t* open;
  const std::uint32_t* links;
  int low, high;  ///< rows with cells of the unit
};

/// The rows that have a bit.
void set_range(Pass& pass) {
  pass.low = 0, pass.high = kTile - 1;
  while (pass.low < pass.high && pass.open[pass.low] == 0) ++pass.low;
  while (pass.low < pass.high && pass.open[pass.high] == 0) --pass.high;
}

/// A row of activation with its neighbours to both sides. Where every diagonal is open only the sum is asked for.
template <bool Plain>
struct Beside;
template <>
struct Beside<true> {
  Row sum;
  Beside(Row x, double left, double right) : sum(x.from_left(left) + x.from_right(right)) {}
  Beside(const double* sums, const double*) : sum(Row::load(sums)) {}
  void store(double* sums, double*) const { sum.store(sums); }
  Row both() const { return sum; }
  Row linked(std::uint32_t) const { return sum; }
};
template <>
struct Beside<false> {
  Row west, east;
  Beside(Row x, double left, double right) : west(x.from_left(left)), east(x.from_right(right)) {}
  Beside(const double* lefts, const double* rights) : west(Row::load(lefts)), east(Row::load(rights)) {}
  void store(double* lefts, double* rights) const { west.store(lefts), east.store(rights); }
  Row both() const { return west + east; }
  /// Of `links` bit p is set where the cells p - 1 and p of both rows are all open.
  Row linked(std::uint32_t links) const { return masked_sum(west, links, east, links >> 1); }
};

template <bool Full, bool Plain, bool Curved>
class Sweep {
 public:
  Sweep(TileScratch& tile, const Pass& pass)
      : tile_(tile),
        pass_(pass),
        keep_(Row::all(tile.keep)),
        straight_(Row::all(tile.straight)),
        slant_(Row::all(tile.slant)) {
    const int first = pass.low > 0 ? pass.low - 1 : 0, last = pass.high < kTile - 1 ? pass.high + 1 : kTile - 1;
    for (int r = first; r <= last; ++r)
      Beside<Plain>(Row::load(pass.cell[r]), pass.left[r], pass.right[r]).store(tile.west[r], tile.east[r]);
  }

  /// Two fronts cross the tile, so that neither waits for the other. Flat, as rows in memory would be slow.
  [[gnu::flatten]] std::int32_t run() {
    Front up = before(pass_.low), down = after(pass_.high);
    Change change;
    const int rows = pass_.high - pass_.low + 1;
    int low = pass_.low, high = pass_.high;
    for (; low < high; ++low, --high) {
      step<true, false>(up, low, change);
      step<false, false>(down, high, change);
    }
    if (rows % 2 != 0) {
      step<true, false>(up, low, change);
      step<false, true>(down, high, change);
      ++low, --high;
    }
    for (; low <= pass_.high; ++low, --high) {
      step<true, true>(up, low, change);
      step<false, true>(down, high, change);
    }
    return change.most();
  }

  double residual() {
    Row worst = Row::all(0);
    for (int r = pass_.low; r <= pass_.high; ++r) {
      const Front lower = before(r), upper = after(r);
      const Row c = Row::load(pass_.cell[r]);
      Row u = straight_ * (Beside<Plain>(tile_.west[r], tile_.east[r]).both() + lower.x + upper.x) +
              slant_ * (lower.beside.linked(lower.links) + upper.beside.linked(upper.links));
      if (Curved) u = squashed(u);
      Row off = (c - u).magnitude() / (u + Row::all(kTiny));
      if (Curved) off = off * is_free(r);
      if (!Full) off = off.masked(pass_.open[r]);
      worst = worst.larger(off);
    }
    return worst.most();
  }

 private:
  static constexpr double kSmall =
      0x1p-700;  // below what a path might follow; no change of a cell that is 0 looks large
  static constexpr double kTiny = 0x1p-1000;  // far below the least activation of a unit

  struct Front {
    Row x;
    Beside<Plain> beside;
    std::uint32_t links;  ///< diagonals across the border to the row that it comes to
  };

  /// Border b is below row b.
  std::uint32_t links(int b) const { return Plain ? 0 : pass_.links[b]; }
  Beside<Plain> beyond_first() const { return {Row::load(pass_.first), pass_.corner[0], pass_.corner[1]}; }
  Beside<Plain> beyond_last() const { return {Row::load(pass_.last), pass_.corner[2], pass_.corner[3]}; }
  /// What lies before the row, and after it.
  Front before(int r) const {
    if (r == 0) return {Row::load(pass_.first), beyond_first(), links(0)};
    return {Row::load(pass_.cell[r - 1]), {tile_.west[r - 1], tile_.east[r - 1]}, links(r)};
  }
  Front after(int r) const {
    if (r == kTile - 1) return {Row::load(pass_.last), beyond_last(), links(kTile)};
    return {Row::load(pass_.cell[r + 1]), {tile_.west[r + 1], tile_.east[r + 1]}, links(r + 1)};
  }
  /// 1, and 0 for targets, whose gain is 0.
  Row is_free(int r) const { return Row::load(pass_.gain[r]) / (Row::load(pass_.gain[r]) + Row::all(kTiny)); }

  static Row squashed(Row u) {  // see squash()
    const Row q = u * u;
    return u * (Row::all(135135) + q * (Row::all(17325) + q * (Row::all(378) + q))) /
           (Row::all(135135) + q * (Row::all(62370) + q * (Row::all(3150) + q * Row::all(28))));
  }

  /// Row r by its equation.
  template <bool Upward, bool Last>
  void step(Front& front, int r, Change& change) {
    const Front next = Upward ? after(r) : before(r);
    const Row c = Row::load(pass_.cell[r]);
    const Beside<Plain> own(tile_.west[r], tile_.east[r]);
    const Row input = straight_ * (own.both() + next.x) + slant_ * next.beside.linked(next.links);
    Row x = Curved
                ? Row::load(pass_.hold[r]) * c + Row::load(pass_.gain[r]) * ((input + straight_ * front.x) +
                                                                             slant_ * front.beside.linked(front.links))
                : ((keep_ * c + input) + straight_ * front.x) + slant_ * front.beside.linked(front.links);
    if (!Full) x = x.masked(pass_.open[r]);
    if (Last) {
      x = x.larger(Row::all(0));
      change.see((x - c).magnitude(), x + Row::all(kSmall));
    }
    x.store(pass_.cell[r]);
    front = {x, {x, pass_.left[r], pass_.right[r]}, next.links};
    if (!Last) front.beside.store(tile_.west[r], tile_.east[r]);  // for the other front
  }

  TileScratch& tile_;
  const Pass& pass_;
  Row keep_, straight_, slant_;
};

/// What lies along the sides, and the unit's cells alone.
[[gnu::flatten]] void take(TileScratch& t) {
  constexpr int kEnd = kTile - 1;
  const double* const lines[4] = {t.home->cell[0], t.home->cell[kEnd], t.home->side[0], t.home->side[1]};
  const std::uint32_t bits[4] = {t.open[0][0], t.open[0][kEnd], t.open[1][0], t.open[1][kEnd]};
  for (int side = 0; side < 4; ++side) {
    const Row line = t.fresh ? Row::all(0) : Row::load(lines[side]);
    (t.shared ? line.masked(bits[side]) : line).store(t.old[side]);
  }
  t.cell = t.home->cell;
  if (!t.shared) return;
  t.cell = t.own;
  for (int r = 0; r < kTile; ++r) Row::load(t.home->cell[r]).masked(t.open[0][r]).store(t.own[r]);
}

/// Brings them back to the tile.
[[gnu::flatten]] void give(TileScratch& t) {
  constexpr int kEnd = kTile - 1;
  Row::load(t.cell[0]).store(t.now[TileScratch::below]);
  Row::load(t.cell[kEnd]).store(t.now[TileScratch::above]);
  for (int side = 0; side < 2; ++side) {
    const int x = side * kEnd;
    double* now = t.now[TileScratch::left + side];
    if (t.sweep_columns)
      Row::load(t.turned[x]).store(now);
    else
      for (int r = 0; r < kTile; ++r) now[r] = t.cell[r][x];
    Row column = Row::load(now);
    if (t.shared) column = column + Row::load(t.home->side[side]).masked(~std::uint32_t{t.open[1][x]});
    column.store(t.home->side[side]);
  }
  if (!t.shared) return;
  for (int r = 0; r < kTile; ++r) {
    double* row = t.home->cell[r];
    (Row::load(t.own[r]) + Row::load(row).masked(~std::uint32_t{t.open[0][r]})).store(row);
  }
}

/// How much the neighbours across feel: the change of their input, relative to what they have.
[[gnu::flatten]] void tell(TileScratch& t) {
  const Row straight = Row::all(t.beta), slant = Row::all(t.beta * kRootHalf);
  const auto felt_of = [&](Row x) { return straight * x + slant * (x.from_left(0) + x.from_right(0)); };
  Row highest = Row::all(0);
  for (int side = 0; side < 4; ++side) {
    const Row now = Row::load(t.now[side]);
    highest = highest.larger(now);
    TileScratch::Told& told = t.told[side];
    told.cells = 0;
    if (t.across[side] == 0) continue;
    const Row felt = felt_of((now - Row::load(t.old[side])).magnitude());
    const Row have = Row::load(t.edge[side]).larger(felt_of(now));
    told.cells = felt.above(Row::all(t.threshold) * have) & t.across[side];
    if (told.cells == 0) continue;
    Change share;
    share.see(felt.masked(told.cells), have + Row::all(0x1p-1000));
    told.share = share.most();
    told.highest = now.most();
  }
  t.highest = highest.most();
}

Pass pass_over_rows(TileScratch& t) {
  return {t.cell,
          t.gain,
          t.hold,
          t.edge[TileScratch::below],
          t.edge[TileScratch::above],
          t.edge[TileScratch::left],
          t.edge[TileScratch::right],
          {t.corner[0], t.corner[1], t.corner[2], t.corner[3]},
          t.open[0],
          t.links[0],
          0,
          kTile - 1};
}

Pass pass_over_columns(TileScratch& t) {
  return {t.turned,
          t.turned_gain,
          t.turned_hold,
          t.edge[TileScratch::left],
          t.edge[TileScratch::right],
          t.edge[TileScratch::below],
          t.edge[TileScratch::above],
          {t.corner[0], t.corner[2], t.corner[1], t.corner[3]},
          t.open[1],
          t.links[1],
          0,
          kTile - 1};
}

template <bool Full, bool Plain, bool Curved>
void relax_as(TileScratch& t) {
  t.change = INT32_MIN;
  if (t.sweep_rows) {
    Pass pass = pass_over_rows(t);
    if (!Full) set_range(pass);
    t.change = Sweep<Full, Plain, Curved>(t, pass).run();
  }
  if (!t.sweep_columns) return;
  Row::transpose(t.cell, t.turned);
  if (Curved) Row::transpose(t.gain, t.turned_gain), Row::transpose(t.hold, t.turned_hold);
  Pass pass = pass_over_columns(t);
  if (!Full) set_range(pass);
  t.change = Sweep<Full, Plain, Curved>(t, pass).run();
  Row::transpose(t.turned, t.cell);
}

template <bool Full, bool Plain, bool Curved>
double residual_as(TileScratch& t) {
  Pass pass = pass_over_rows(t);
  if (!Full) set_range(pass);
  return Sweep<Full, Plain, Curved>(t, pass).residual();
}

void relax(TileScratch& t) {
  take(t);
  if (t.gain != nullptr)
    relax_as<false, false, true>(t);
  else if (t.links[0] != nullptr)
    relax_as<false, false, false>(t);
  else if (!t.full)
    relax_as<false, true, false>(t);
  else
    relax_as<true, true, false>(t);
  give(t);
  tell(t);
}

double residual(TileScratch& t) {
  take(t);
  if (t.gain != nullptr) return residual_as<false, false, true>(t);
  if (t.links[0] != nullptr) return residual_as<false, false, false>(t);
  if (!t.full) return residual_as<false, true, false>(t);
  return residual_as<true, true, false>(t);
}

}  // namespace
}  // namespace meander

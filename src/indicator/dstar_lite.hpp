// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <tuple>
#include <vector>

#include "base/work.hpp"
#include "grid/grid.hpp"

namespace meander {

/// [KL02] D* Lite: a shortest way over cells from a start that moves to a goal that does not, kept up while cells turn
/// out to be blocked or free: only what a change reaches is worked out anew. Every cell is free at first. Steps along
/// the rows count 5 fifths of a cell, diagonal ones 7; a diagonal step needs both cells beside it.
class DStarLite {
 public:
  /// `diagonal`: whether there are diagonal steps. Throws ArgumentError when the goal is not in the grid.
  DStarLite(int width, int height, Cell goal, bool diagonal = true);

  void set_blocked(Cell cell, bool blocked);
  bool blocked(Cell cell) const { return blocked_.at(cell, 1) != 0; }

  /// The cells from the start to the goal, both included; empty: no way leads there.
  const std::vector<Cell>& plan(Cell start, const Work& work = {});
  /// Of the way that was planned last [cells]; infinite: there was none.
  double length() const;

  int width() const { return blocked_.width(); }
  int height() const { return blocked_.height(); }
  std::uint64_t expanded() const { return expanded_; }  ///< cells, in all plans
  std::size_t bytes() const;                            ///< of memory, about

 private:
  using Key = std::pair<int, int>;
  struct Entry {
    Key key;
    Cell cell;
    /// Of equal keys the lower row, then the lower column comes first: the order of insertion must not matter.
    bool operator<(const Entry& other) const {
      return std::tuple(other.key, other.cell.y, other.cell.x) < std::tuple(key, cell.y, cell.x);
    }
  };
  struct Node {
    int g, rhs;
    Key key;
    bool queued;
  };

  Key key_of(Cell cell) const;
  int estimate(Cell a, Cell b) const;
  /// Calls visit(neighbour, cost) for the free cells that a step leads to.
  template <class Visit>
  void for_steps(Cell from, Visit visit) const;
  void update(Cell cell);
  void update_beside(Cell cell);
  void push(Cell cell);
  const Entry* top();
  void pop();
  void compute(const Work& work);

  Grid<std::uint8_t> blocked_;
  Grid<Node> nodes_;
  Cell goal_, start_;
  bool diagonal_;
  bool begun_ = false;
  int moved_ = 0;             ///< [KL02] k_m: how far the start has moved, by the estimate
  std::vector<Entry> queue_;  ///< a heap; entries whose node has another key by now are skipped
  std::vector<Cell> way_;
  std::uint64_t expanded_ = 0;
};

}  // namespace meander

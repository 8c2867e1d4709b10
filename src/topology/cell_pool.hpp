// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.hpp"

namespace meander::topology {

/// One half of a link; the other cell holds the other half with the same values.
struct Link {
  int to = -1;
  double weight = 1;       ///< a, in (0, 1]
  double doubt = 0;        ///< contacts that speak against it
  bool suspended = false;  ///< believed to be blocked; kept, because it may come back
  bool operator==(const Link&) const = default;
};

/// A place of the map.
struct Cell {
  Vec2 position{0, 0};       ///< in the map's frame [m]
  std::uint64_t serial = 0;  ///< tells cells apart that had the same number; 0: the number is free
  std::int64_t born = 0;     ///< sample
  std::int64_t hits = 0;     ///< u: how often it won
  std::vector<Link> links;
  bool alive() const { return serial != 0; }
};

/// The cells of a net with their senses and links. Numbers of removed cells are used again.
class CellPool {
 public:
  explicit CellPool(int stride) : stride_(static_cast<std::size_t>(stride)) {}

  int add(const Vec2& position, const float* senses, std::int64_t sample);
  /// With its links.
  void remove(int cell);

  /// Numbers in use are below this.
  int slots() const { return static_cast<int>(cells_.size()); }
  int size() const { return slots() - static_cast<int>(free_.size()); }
  bool alive(int cell) const { return cell >= 0 && cell < slots() && (*this)[cell].alive(); }
  const Cell& operator[](int cell) const { return cells_[static_cast<std::size_t>(cell)]; }
  Cell& operator[](int cell) { return cells_[static_cast<std::size_t>(cell)]; }
  float* senses(int cell) { return senses_.data() + static_cast<std::size_t>(cell) * stride_; }
  const float* senses(int cell) const { return senses_.data() + static_cast<std::size_t>(cell) * stride_; }
  std::size_t stride() const { return stride_; }

  /// One half of a link, or nullptr.
  Link* find(int from, int to);
  const Link* find(int from, int to) const { return const_cast<CellPool*>(this)->find(from, to); }
  /// Both halves become like `link`, which is made if there is none. (`link.to` does not matter.)
  void connect(int a, int b, const Link& link);
  void disconnect(int a, int b);

 private:
  friend struct PoolState;
  std::size_t stride_;
  std::vector<Cell> cells_;
  std::vector<float> senses_;  ///< stride_ values a cell
  std::vector<int> free_;      ///< the last is used first
  std::uint64_t serials_ = 0;
};

}  // namespace meander::topology

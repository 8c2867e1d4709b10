// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/dstar_lite.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "indicator/cell_moves.hpp"

namespace meander {
namespace {

constexpr int kFar = 1 << 29;  ///< no way leads there; twice as much is still a number

}  // namespace

DStarLite::DStarLite(int width, int height, Cell goal, bool diagonal)
    : blocked_(width, height),
      nodes_(width, height, Node{kFar, kFar, {}, false}),
      goal_(goal),
      start_(goal),
      diagonal_(diagonal) {
  if (!blocked_.contains(goal)) fail("goal: a cell of the grid expected, got ({}, {})", goal.x, goal.y);
}

template <class Visit>
void DStarLite::for_steps(Cell from, Visit visit) const {
  if (blocked(from)) return;
  for (const CellMove& move : kCellMoves) {
    const Cell to{from.x + move.dx, from.y + move.dy};
    if (blocked(to)) continue;
    if (move.length == kDiagonal && (!diagonal_ || blocked({from.x, to.y}) || blocked({to.x, from.y}))) continue;
    visit(to, move.length);
  }
}

int DStarLite::estimate(Cell a, Cell b) const {
  const int dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  if (!diagonal_) return kStraight * (dx + dy);
  return kStraight * std::max(dx, dy) + (kDiagonal - kStraight) * std::min(dx, dy);
}

DStarLite::Key DStarLite::key_of(Cell cell) const {
  const int least = std::min(nodes_[cell].g, nodes_[cell].rhs);
  return {least + estimate(start_, cell) + moved_, least};
}

/// [KL02] Figure 4, UpdateVertex.
void DStarLite::update(Cell cell) {
  Node& node = nodes_[cell];
  if (!(cell == goal_)) {
    node.rhs = kFar;
    for_steps(cell, [&](Cell to, int cost) { node.rhs = std::min(node.rhs, cost + nodes_[to].g); });
  }
  if (node.g == node.rhs)
    node.queued = false;
  else
    push(cell);
}

void DStarLite::update_beside(Cell cell) {
  for (const CellMove& move : kCellMoves) {
    const Cell near{cell.x + move.dx, cell.y + move.dy};
    if (nodes_.contains(near)) update(near);
  }
}

void DStarLite::push(Cell cell) {
  Node& node = nodes_[cell];
  const Key key = key_of(cell);
  if (node.queued && node.key == key) return;
  node.queued = true;
  node.key = key;
  queue_.push_back({key, cell});
  std::push_heap(queue_.begin(), queue_.end());
}

const DStarLite::Entry* DStarLite::top() {
  while (!queue_.empty()) {
    const Node& node = nodes_[queue_.front().cell];
    if (node.queued && node.key == queue_.front().key) return &queue_.front();
    pop();
  }
  return nullptr;
}

void DStarLite::pop() {
  std::pop_heap(queue_.begin(), queue_.end());
  queue_.pop_back();
}

/// [KL02] Figure 4, ComputeShortestPath.
void DStarLite::compute(const Work& work) {
  for (const Entry* first = top(); first; first = top()) {
    if (first->key >= key_of(start_) && nodes_[start_].rhs == nodes_[start_].g) return;
    if ((++expanded_ & 1023) == 0) work.poll();
    const Entry entry = *first;
    pop();
    Node& node = nodes_[entry.cell];
    node.queued = false;
    if (entry.key < key_of(entry.cell)) {
      push(entry.cell);
      continue;
    }
    const bool nearer = node.g > node.rhs;
    node.g = nearer ? node.rhs : kFar;
    update_beside(entry.cell);
    if (!nearer) update(entry.cell);
  }
}

void DStarLite::set_blocked(Cell cell, bool blocked) {
  if (!blocked_.contains(cell) || (blocked_[cell] != 0) == blocked) return;
  blocked_[cell] = blocked ? 1 : 0;
  if (!begun_) return;
  update(cell);
  update_beside(cell);  // steps past its corners have come or gone, too
}

const std::vector<Cell>& DStarLite::plan(Cell start, const Work& work) {
  way_.clear();
  if (!blocked_.contains(start)) return way_;
  if (begun_) moved_ += estimate(start_, start);
  start_ = start;
  if (!std::exchange(begun_, true)) {
    nodes_[goal_].rhs = 0;
    push(goal_);
  }
  compute(work);
  if (blocked(start) || blocked(goal_) || nodes_[start].g >= kFar) return way_;
  way_.push_back(start);
  while (!(way_.back() == goal_)) {
    Cell best = way_.back();
    int least = kFar;
    for_steps(way_.back(), [&](Cell to, int cost) {
      if (cost + nodes_[to].g >= least) return;
      least = cost + nodes_[to].g;
      best = to;
    });
    way_.push_back(best);
  }
  return way_;
}

std::size_t DStarLite::bytes() const {
  return sizeof(DStarLite) + blocked_.cells().size() * (1 + sizeof(Node)) + queue_.capacity() * sizeof(Entry);
}

double DStarLite::length() const {
  if (way_.empty()) return std::numeric_limits<double>::infinity();
  return nodes_[way_.front()].g / static_cast<double>(kStraight);
}

}  // namespace meander

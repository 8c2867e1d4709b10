// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/cell_pool.hpp"

#include <algorithm>

namespace meander::topology {

int CellPool::add(const Vec2& position, const float* senses, std::int64_t sample) {
  int cell = slots();
  if (free_.empty()) {
    cells_.emplace_back();
    senses_.resize(senses_.size() + stride_);
  } else {
    cell = free_.back();
    free_.pop_back();
  }
  Cell& made = (*this)[cell];
  made.position = position;
  made.serial = ++serials_;
  made.born = sample;
  made.hits = 0;
  made.links.clear();
  std::copy_n(senses, stride_, this->senses(cell));
  return cell;
}

void CellPool::remove(int cell) {
  Cell& gone = (*this)[cell];
  while (!gone.links.empty()) disconnect(cell, gone.links.back().to);
  gone.serial = 0;
  free_.push_back(cell);
}

Link* CellPool::find(int from, int to) {
  for (Link& link : (*this)[from].links)
    if (link.to == to) return &link;
  return nullptr;
}

void CellPool::connect(int a, int b, const Link& link) {
  const auto set = [&](int from, int to) {
    Link* half = find(from, to);
    if (!half) half = &(*this)[from].links.emplace_back();
    *half = link;
    half->to = to;
  };
  set(a, b);
  set(b, a);
}

void CellPool::disconnect(int a, int b) {
  const auto drop = [&](int from, int to) {
    auto& links = (*this)[from].links;
    links.erase(std::find_if(links.begin(), links.end(), [to](const Link& link) { return link.to == to; }));
  };
  drop(a, b);
  drop(b, a);
}

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/place_index.hpp"

#include <cmath>
#include <utility>

namespace meander::topology {
namespace {

constexpr std::size_t kFirstSize = 64;
constexpr double kFarthest = 1e15;  ///< buckets beyond this (and what is no number) are one with the first

}  // namespace

PlaceIndex::PlaceIndex(double side) : side_(side), table_(kFirstSize) {}

std::int64_t PlaceIndex::bucket(double metres) const {
  const double number = std::floor(metres / side_);
  return std::abs(number) < kFarthest ? static_cast<std::int64_t>(number) : 0;
}

std::size_t PlaceIndex::slot(std::uint64_t key) const {
  std::uint64_t mixed = key * 0x9e3779b97f4a7c15ULL;
  mixed ^= mixed >> 32;
  std::size_t at = mixed & (table_.size() - 1);
  while (table_[at].head != kFree && table_[at].key != key) at = (at + 1) & (table_.size() - 1);
  return at;
}

void PlaceIndex::grow() {
  std::vector<Bucket> old = std::exchange(table_, std::vector<Bucket>(table_.size() * 2));
  for (const Bucket& bucket : old)
    if (bucket.head != kFree) table_[slot(bucket.key)] = bucket;
}

void PlaceIndex::add(int cell, const Vec2& at) {
  const auto i = static_cast<std::size_t>(cell);
  if (i >= links_.size()) links_.resize(i + 1);
  const std::uint64_t home = key(bucket(at.x()), bucket(at.y()));
  if (table_[slot(home)].head == kFree && 2 * ++used_ > table_.size()) grow();
  Bucket& found = table_[slot(home)];
  if (found.head == kFree) found = {home, -1};
  links_[i] = {home, found.head, -1};
  if (found.head >= 0) links_[static_cast<std::size_t>(found.head)].before = cell;
  found.head = cell;
}

void PlaceIndex::remove(int cell) {
  const Place& place = links_[static_cast<std::size_t>(cell)];
  if (place.next >= 0) links_[static_cast<std::size_t>(place.next)].before = place.before;
  if (place.before >= 0)
    links_[static_cast<std::size_t>(place.before)].next = place.next;
  else
    table_[slot(place.key)].head = place.next;
}

void PlaceIndex::move(int cell, const Vec2& at) {
  if (links_[static_cast<std::size_t>(cell)].key == key(bucket(at.x()), bucket(at.y()))) return;
  remove(cell);
  add(cell, at);
}

void PlaceIndex::clear() {
  table_.assign(kFirstSize, {});
  used_ = 0;
  links_.clear();
}

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/revisit.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander::topology {
namespace {

constexpr double kPassed = 0.25;  ///< a place on the way counts as passed within this [m]
constexpr double kStart = 0.1;    ///< the link is driven from so near to its first place on [m]
constexpr double kBeyond =
    0.3;  ///< and to so far beyond the other [m]: a place before the wall may seem the one behind
constexpr double kAside = 0.25;     ///< farther off its line the link is not driven any more [m]
constexpr double kProgress = 0.05;  ///< [m]
const double kAhead = radians(60);  ///< contacts so near to the way hold the robot up
constexpr double kParallel = 0.7;   ///< least cosine between links of one direction

}  // namespace

Revisit::Revisit(std::shared_ptr<TopologicMap> map, const RevisitOptions& options)
    : map_(std::move(map)), options_(options) {
  validate(options);
}

const Revisit::Tried* Revisit::tried(int a, int b) const {
  const auto found = std::find_if(tried_.begin(), tried_.end(),
                                  [&](const Tried& t) { return (t.a == a && t.b == b) || (t.a == b && t.b == a); });
  return found == tried_.end() ? nullptr : &*found;
}

bool Revisit::due(int from, const Link& link) const {
  if (link.doubt == 0 && !link.suspended) return false;
  const Tried* last = tried(from, link.to);
  return !last || (last->tries < options_.tries && map_->samples() - last->sample >= options_.pause);
}

/// Numbers of cells are used again.
void Revisit::forget_removed() {
  const auto gone = [&](int cell, std::uint64_t serial) {
    return !cells().alive(cell) || cells()[cell].serial != serial;
  };
  std::erase_if(tried_, [&](const Tried& t) { return gone(t.a, t.serial_a) || gone(t.b, t.serial_b); });
}

bool Revisit::begin() {
  forget_removed();
  way_.clear();
  const int from = nearest_place(cells(), here());
  if (from < 0) return false;
  const auto due_link = [&](int cell) {
    const auto& links = cells()[cell].links;
    const auto found = std::find_if(links.begin(), links.end(), [&](const Link& link) { return due(cell, link); });
    return found == links.end() ? nullptr : &*found;
  };
  auto way = route_to_nearest(cells(), from, [&](int cell) { return due_link(cell) != nullptr; });
  if (!way) return false;
  way_ = std::move(*way);
  way_.push_back(due_link(way_.back())->to);
  serial_a_ = cells()[way_[way_.size() - 2]].serial;
  serial_b_ = cells()[way_.back()].serial;
  next_ = 0;
  phase_ = Phase::approach;
  aim();
  return true;
}

void Revisit::aim() {
  nearest_ = 1e9;
  since_ = held_ = 0;
}

std::optional<std::pair<int, int>> Revisit::link() const {
  if (way_.empty()) return std::nullopt;
  return std::pair(way_[way_.size() - 2], way_.back());
}

std::optional<Vec2> Revisit::next(const WhiskerContacts& contacts) {
  if (way_.empty()) return std::nullopt;
  const int a = way_[way_.size() - 2], b = way_.back();
  const auto same = [&](int cell, std::uint64_t serial) {
    return cells().alive(cell) && cells()[cell].serial == serial;
  };
  if (!same(a, serial_a_) || !same(b, serial_b_) || !cells().find(a, b)) return std::nullopt;  // learning took it
  return phase_ == Phase::approach ? approach() : pass(contacts);
}

bool Revisit::comes_nearer(double left) {
  if (left < nearest_ - kProgress) {
    nearest_ = left;
    since_ = held_ = 0;
  }
  return ++since_ <= options_.patience;
}

std::optional<Vec2> Revisit::approach() {
  const std::size_t last = way_.size() - 2;
  const auto left = [&] { return (at(way_[next_]) - here()).norm(); };
  if (!cells().alive(way_[next_])) return std::nullopt;
  while (left() < (next_ == last ? kStart : kPassed)) {
    if (next_ == last) {
      phase_ = Phase::pass;
      const Vec2 link = at(way_.back()) - at(way_[last]);
      start_ = at(way_[last]);
      end_ = at(way_.back()) + kBeyond / std::max(link.norm(), 1e-9) * link;
      aim();
      return end_;
    }
    ++next_;
    aim();
    if (!cells().alive(way_[next_])) return std::nullopt;
  }
  if (comes_nearer(left())) return at(way_[next_]);
  judge(false, false);
  return std::nullopt;
}

/// Do contacts stand in the way?
bool Revisit::held_by(const WhiskerContacts& contacts) const {
  const Vec2 way = end_ - here();
  return !contacts.free(wrap_angle(angle_of(way.y(), way.x()) - map_->pose().heading), kAhead);
}

std::optional<Vec2> Revisit::pass(const WhiskerContacts& contacts) {
  const Vec2 along = (end_ - start_) / (end_ - start_).norm(), way = end_ - here();
  const double left = way.dot(along), off = (way - left * along).norm();
  if (off > kAside) {  // slid off along what is in the way, perhaps round its end
    judge(false, held_ > 0);
    return std::nullopt;
  }
  if (left <= kStart) {
    judge(true, false);
    return std::nullopt;
  }
  held_ += held_by(contacts);
  if (comes_nearer(left)) return end_;
  judge(false, 2 * held_ > options_.patience);
  return std::nullopt;
}

void Revisit::judge(bool passed, bool blocked) {
  const int a = way_[way_.size() - 2], b = way_.back();
  const double suspend = map_->options().doubt.suspend;
  Link link = *cells().find(a, b);
  if (passed) link = {};  // as rule (7) of [Z] leaves a link that was driven
  if (blocked && suspend > 0) {
    link.doubt = std::min(link.doubt + 1, suspend);
    link.suspended = link.doubt >= suspend;
  }
  map_->net().cells().connect(a, b, link);
  const Tried* last = tried(a, b);
  const int tries = passed ? 0 : (last ? last->tries : 0) + 1;
  std::erase_if(tried_, [&](const Tried& t) { return &t == last; });
  tried_.push_back({a, b, serial_a_, serial_b_, tries, map_->samples()});
  if (blocked && suspend > 0 && options_.beside > 0) doubt_beside(at(b) - at(a));
}

/// What holds the robot up here may stand across the links beside, too: a contact against each that has none.
void Revisit::doubt_beside(const Vec2& direction) {
  GrowingNet& net = map_->net();
  const Vec2 middle = 0.5 * (start_ + at(way_.back()));
  const double suspend = map_->options().doubt.suspend;
  std::vector<std::pair<int, int>> beside;
  net.around(middle, options_.beside + 1, [&](int cell) {
    for (const Link& link : cells()[cell].links) {
      const Vec2 way = at(link.to) - at(cell);
      if (cell > link.to || link.doubt > 0 || tried(cell, link.to)) continue;
      if ((0.5 * (at(cell) + at(link.to)) - middle).norm() > options_.beside) continue;
      if (std::abs(way.dot(direction)) < kParallel * way.norm() * direction.norm()) continue;
      beside.emplace_back(cell, link.to);
    }
  });
  for (const auto& [from, to] : beside) {
    Link link = *cells().find(from, to);
    link.doubt = std::min(1.0, suspend);
    net.cells().connect(from, to, link);
  }
}

}  // namespace meander::topology

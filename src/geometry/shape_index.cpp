// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_index.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "geometry/segment.hpp"
#include "geometry/shape_pieces.hpp"

namespace meander {

struct ShapeIndex::State {
  std::map<std::uint32_t, ShapePieces> owners;
  std::vector<Material> materials;
  std::vector<Box> edits;
  std::size_t walls = 0;
};

ShapeIndex::ShapeIndex(double) : state_(std::make_unique<State>()) {}
ShapeIndex::ShapeIndex(const ShapeIndex& other) : state_(std::make_unique<State>(*other.state_)) {}
ShapeIndex& ShapeIndex::operator=(const ShapeIndex& other) { return *this = ShapeIndex(other); }
ShapeIndex::ShapeIndex(ShapeIndex&&) noexcept = default;
ShapeIndex& ShapeIndex::operator=(ShapeIndex&&) noexcept = default;
ShapeIndex::~ShapeIndex() = default;

void ShapeIndex::insert(std::uint32_t owner, const Shape& shape, const Material& material) {
  state_->materials.push_back(material);
  const auto [it, fresh] = state_->owners.emplace(owner, pieces_of(shape));
  if (!fresh) fail("shape index: owner {} already has a shape", owner);
  for (Wall& w : it->second.walls)
    w.owner = owner, w.material = static_cast<std::uint16_t>(state_->materials.size() - 1);
  if (it->second.pole)
    it->second.pole->owner = owner,
    it->second.pole->material = static_cast<std::uint16_t>(state_->materials.size() - 1);
  state_->walls += it->second.walls.size();
  state_->edits.push_back(bounding_box(shape));
}

void ShapeIndex::remove(std::uint32_t owner) {
  const auto it = state_->owners.find(owner);
  if (it == state_->owners.end()) fail("shape index: owner {} has no shape", owner);
  Box box = it->second.box;
  state_->walls -= it->second.walls.size();
  state_->owners.erase(it);
  state_->edits.push_back(box);
}

bool ShapeIndex::has(std::uint32_t owner) const { return state_->owners.contains(owner); }

void ShapeIndex::clear() {
  while (!state_->owners.empty()) remove(state_->owners.begin()->first);
}

std::size_t ShapeIndex::wall_count() const { return state_->walls; }
const Material& ShapeIndex::material(std::uint16_t index) const { return state_->materials.at(index); }

std::optional<RayHit> ShapeIndex::cast(const Vec2& origin, const Vec2& direction, double max_range) const {
  NearestHit nearest(origin, direction, max_range);
  for (const auto& [owner, pieces] : state_->owners) {
    for (const Wall& w : pieces.walls) nearest.meet(w);
    if (pieces.pole) nearest.meet(*pieces.pole);
  }
  return nearest.hit();
}

double ShapeIndex::distance(const Vec2& point, double most) const {
  double best = most;
  for (const auto& [owner, pieces] : state_->owners) {
    for (const Wall& w : pieces.walls) best = std::min(best, distance_to_segment(point, w.a, w.b));
    if (pieces.pole)
      best = std::min(best, std::abs((pieces.pole->disc.center - point).norm() - pieces.pole->disc.radius));
  }
  return best;
}

bool ShapeIndex::inside(const Vec2& point) const {
  for (const auto& [owner, pieces] : state_->owners) {
    int winding = 0;
    for (const Wall& w : pieces.walls) {
      if (!w.solid) continue;
      if (distance_to_segment(point, w.a, w.b) <= kTouch) return true;
      winding += winding_step(point, w.a, w.b);
    }
    if (winding != 0) return true;
    if (pieces.pole && contains(pieces.pole->disc, point)) return true;
  }
  return false;
}

void ShapeIndex::gather(const Vec2& center, double radius, std::vector<Wall>& walls, std::vector<Pole>& poles) const {
  walls.clear();
  poles.clear();
  for (const auto& [owner, pieces] : state_->owners) {
    for (const Wall& w : pieces.walls)
      if (distance_to_segment(center, w.a, w.b) <= radius) walls.push_back(w);
    if (pieces.pole && (pieces.pole->disc.center - center).norm() <= radius + pieces.pole->disc.radius)
      poles.push_back(*pieces.pole);
  }
}

std::uint64_t ShapeIndex::revision() const { return state_->edits.size(); }

bool ShapeIndex::touched_since(std::uint64_t revision, const Vec2& center, double radius) const {
  for (std::size_t i = revision; i < state_->edits.size(); ++i) {
    const Vec2 nearest = center.cwiseMax(state_->edits[i].low).cwiseMin(state_->edits[i].high);
    if ((nearest - center).norm() <= radius) return true;
  }
  return false;
}

}  // namespace meander

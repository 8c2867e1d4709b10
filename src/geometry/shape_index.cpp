// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_index.hpp"

#include "geometry/nearest_hit.hpp"
#include "geometry/number_set.hpp"
#include "geometry/shape_index_state.hpp"

namespace meander {
namespace {

bool within(const Vec2& point, double radius, const Wall& wall) {
  const Vec2 d = wall.b - wall.a, e = point - wall.a;
  const double squared = radius * radius, along = e.dot(d), off = cross(d, e);
  if (e.squaredNorm() <= squared || (point - wall.b).squaredNorm() <= squared) return true;
  return along > 0 && along < d.squaredNorm() && off * off <= squared * d.squaredNorm();
}

}  // namespace

ShapeIndex::ShapeIndex(double cell) : state_(std::make_unique<State>(cell)) {}
ShapeIndex::ShapeIndex(const ShapeIndex& other) : state_(std::make_unique<State>(*other.state_)) {}
ShapeIndex& ShapeIndex::operator=(const ShapeIndex& other) { return *this = ShapeIndex(other); }
ShapeIndex::ShapeIndex(ShapeIndex&&) noexcept = default;
ShapeIndex& ShapeIndex::operator=(ShapeIndex&&) noexcept = default;
ShapeIndex::~ShapeIndex() = default;

void ShapeIndex::insert(std::uint32_t owner, const Shape& shape, const Material& material) {
  state_->insert(owner, shape, material);
}

void ShapeIndex::remove(std::uint32_t owner) { state_->remove(owner); }

bool ShapeIndex::has(std::uint32_t owner) const {
  return owner < state_->owners.size() && state_->owners[owner].present;
}

void ShapeIndex::clear() {
  for (std::uint32_t owner = 0; owner < state_->owners.size(); ++owner)
    if (has(owner)) remove(owner);
}

std::size_t ShapeIndex::wall_count() const { return state_->wall_count; }

const Material& ShapeIndex::material(std::uint32_t index) const { return state_->materials.at(index); }

std::optional<RayHit> ShapeIndex::cast(const Vec2& origin, const Vec2& direction, double max_range) const {
  return state_->grid.cast({origin, direction, max_range}, state_->walls.data(), origin, direction).hit();
}

double ShapeIndex::distance(const Vec2& point, double most) const {
  return state_->grid.distance(state_->walls.data(), point, most);
}

bool ShapeIndex::inside(const Vec2& point) const { return state_->grid.inside(state_->walls.data(), point); }

void ShapeIndex::gather(const Vec2& center, double radius, std::vector<Wall>& walls, std::vector<Pole>& poles) const {
  const State& state = *state_;
  // Scratch of the thread, so that several may ask one index. The sets put the pieces in order, and each in once.
  thread_local NumberSet near_walls, near_owners;
  near_walls.clear(state.walls.size());
  near_owners.clear(state.owners.size());
  state.grid.around(
      center, radius, [&](std::uint32_t id) { near_walls.insert(id), near_owners.insert(state.walls[id].owner); },
      [&](std::uint32_t owner) { near_owners.insert(owner); });
  walls.clear();
  poles.clear();
  const std::size_t end = state.owners.size();
  for (std::size_t slot = near_owners.next(0, end); slot < end; slot = near_owners.next(slot + 1, end)) {
    const State::Owner& owner = state.owners[slot];
    const std::size_t last = owner.walls.first + owner.walls.count;
    for (std::size_t id = near_walls.next(owner.walls.first, last); id < last; id = near_walls.next(id + 1, last)) {
      const Wall& wall = state.walls[static_cast<std::uint32_t>(id)];
      if (within(center, radius, wall)) walls.push_back(wall);
    }
    if (owner.round && (owner.disc.center - center).norm() <= radius + owner.disc.radius)
      poles.push_back({owner.disc, static_cast<std::uint32_t>(slot), owner.material});
  }
}

void ShapeIndex::around(const Vec2& center, double radius, const std::function<void(const Wall&)>& wall,
                        const std::function<void(const Disc&)>& disc) const {
  const State& state = *state_;
  state.grid.around(
      center, radius,
      [&](std::uint32_t id) {
        if (within(center, radius, state.walls[id])) wall(state.walls[id]);
      },
      [&](std::uint32_t owner) {
        const Disc& found = state.owners[owner].disc;
        if ((found.center - center).norm() <= radius + found.radius) disc(found);
      });
}

std::uint64_t ShapeIndex::revision() const { return state_->revision; }

bool ShapeIndex::touched_since(std::uint64_t revision, const Vec2& center, double radius) const {
  if (revision + State::kEditsKept < state_->revision) return true;
  for (std::uint64_t i = revision; i < state_->revision; ++i) {
    const Box& box = state_->edits[i % State::kEditsKept];
    const Vec2 nearest = center.cwiseMax(box.low).cwiseMin(box.high);
    if ((nearest - center).squaredNorm() <= radius * radius) return true;
  }
  return false;
}

}  // namespace meander

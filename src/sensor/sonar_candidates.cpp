// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/segment.hpp"

namespace meander::sonar {
namespace {

constexpr std::size_t kBlock = 8;
constexpr double kRingWidth = 0.25;  ///< the order of the list is by rings of this width [m]
constexpr float kUnused = std::numeric_limits<float>::quiet_NaN();
/// Rounding of single precision in a half-plane's value, as a share of the list's radius; generous.
constexpr double kMargin = 4e-6;

/// The part of a wall within the disc, a little enlarged: what lies farther is out of range, and would need more
/// digits.
std::pair<Vec2, Vec2> near_part(const Face& wall, const Vec2& center, double radius) {
  const Vec2 a = wall.a - center, b = wall.b - center, d = b - a;
  const double dd = d.squaredNorm(), ad = a.dot(d), r = 1.01 * radius;
  if (std::max(a.squaredNorm(), b.squaredNorm()) <= r * r) return {a, b};
  const double root = std::sqrt(std::max(0.0, ad * ad - dd * (a.squaredNorm() - r * r)));
  return {a + std::clamp((-ad - root) / dd, 0.0, 1.0) * d, a + std::clamp((-ad + root) / dd, 0.0, 1.0) * d};
}

void put(Lanes* lanes, std::size_t lane, double value) { lanes[lane / 4][lane % 4] = static_cast<float>(value); }

WallBlock block_of(std::span<const Face> faces, const Vec2& center, double radius) {
  WallBlock block;
  for (Lanes* lanes : {block.ax, block.ay, block.bx, block.by}) lanes[0] = lanes[1] = all(kUnused);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto [a, b] = near_part(faces[i], center, radius);
    put(block.ax, i, a.x()), put(block.ay, i, a.y());
    put(block.bx, i, b.x()), put(block.by, i, b.y());
    block.convex_a |= unsigned{faces[i].convex_a} << i;
    block.convex_b |= unsigned{faces[i].convex_b} << i;
  }
  return block;
}

DiscBlock block_of(std::span<const Pole> poles, const Vec2& center, double radius) {
  DiscBlock block;
  for (Lanes* lanes : {block.x, block.y, block.radius}) lanes[0] = lanes[1] = all(kUnused);
  for (std::size_t i = 0; i < poles.size(); ++i) {
    const Disc& disc = poles[i].disc;
    const Vec2 p = disc.center - center;
    const bool huge = disc.radius > radius;  // too large for single precision: never culled
    put(block.x, i, huge ? 0 : p.x()), put(block.y, i, huge ? 0 : p.y());
    put(block.radius, i, huge ? kNever : disc.radius);
  }
  return block;
}

template <class Thing, class Block>
void fill_blocks(Shelf<Thing, Block>& shelf, const Vec2& center, double radius) {
  shelf.blocks.clear();
  const std::span<const Thing> things(shelf.things);
  for (std::size_t i = 0; i < things.size(); i += kBlock)
    shelf.blocks.push_back(block_of(things.subspan(i, std::min(kBlock, things.size() - i)), center, radius));
}

double distance(const Face& face, const Vec2& p) { return std::sqrt(squared_distance_to_segment(p, face.a, face.b)); }
double distance(const Pole& pole, const Vec2& p) { return (pole.disc.center - p).norm() - pole.disc.radius; }

}  // namespace

/// Sorts by rings around the centre, keeping the order within a ring, and notes the least distance from each block on.
template <class Thing, class Block>
void Candidates::sort_outward(const std::vector<Thing>& from, Shelf<Thing, Block>& to) {
  const auto ring = [](double d) { return static_cast<std::size_t>(d / kRingWidth); };
  distance_.clear();
  rings_.assign(ring(radius_) + 3, 0);
  for (const Thing& thing : from) {
    distance_.push_back(std::clamp(distance(thing, center_), 0.0, radius_));
    ++rings_[ring(distance_.back()) + 1];
  }
  for (std::size_t i = 1; i < rings_.size(); ++i) rings_[i] += rings_[i - 1];
  order_.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) order_[rings_[ring(distance_[i])]++] = static_cast<std::uint32_t>(i);

  to.things.clear();
  for (const std::uint32_t i : order_) to.things.push_back(from[i]);
  to.distance.assign((from.size() + kBlock - 1) / kBlock + 1, kNever);
  for (std::size_t i = from.size(); i-- > 0;) {
    double& block = to.distance[i / kBlock];
    block = std::min(block, distance_[order_[i]]);
    if (i % kBlock == 0 && i > 0) to.distance[i / kBlock - 1] = block;
  }
  fill_blocks(to, center_, radius_);
}

std::uint32_t Candidates::kind_of(const Material& material) {
  const auto same = [&](const Material& m) {
    return m.echo == material.echo &&
           std::bit_cast<std::uint64_t>(m.specular_limit) == std::bit_cast<std::uint64_t>(material.specular_limit);
  };
  const auto known = std::find_if(materials_.begin(), materials_.end(), same);
  if (known == materials_.end()) {
    materials_.push_back(material);
    return static_cast<std::uint32_t>(materials_.size() - 1);
  }
  return static_cast<std::uint32_t>(known - materials_.begin());
}

void Candidates::gather(const ShapeIndex& index, const Vec2& center, double radius) {
  center_ = center;
  radius_ = radius;
  index.gather(center, radius, gathered_walls_, gathered_poles_);
  number_materials(index);
  gathered_faces_.assign(gathered_walls_.begin(), gathered_walls_.end());
  sort_outward(gathered_faces_, faces_);
  sort_outward(gathered_poles_, poles_);
}

void Candidates::number_materials(const ShapeIndex& index) {
  materials_.assign(1, Material{});  // of moving discs
  std::uint32_t last = ~0u;
  std::uint32_t kind = 0;
  const auto number = [&](std::uint32_t& material) {
    if (material != last) kind = kind_of(index.material(material));
    last = material;
    material = kind;
  };
  for (Wall& wall : gathered_walls_) number(wall.material);
  for (Pole& pole : gathered_poles_) number(pole.material);
}

void Candidates::set_moving(std::span<const Pole> moving, std::uint32_t except) {
  moving_.things.clear();
  for (const Pole& pole : moving) {
    if (pole.owner == except || distance(pole, center_) > radius_) continue;
    moving_.things.push_back(pole);
    moving_.things.back().material = 0;
  }
  fill_blocks(moving_, center_, radius_);
}

Cull Candidates::cull(const View& view, const Wedge& wedge) const {
  const Vec2 o = center_ - view.origin;
  const auto plane = [&](const Vec2& normal, double constant, double length) {
    return HalfPlane{all(static_cast<float>(normal.x())), all(static_cast<float>(normal.y())),
                     all(static_cast<float>(constant + normal.dot(o) + length * kMargin * radius_)),
                     all(static_cast<float>(length))};
  };
  Cull cull{.low = plane(view.left - wedge.low * view.ahead, 0, 1 + std::abs(wedge.low)),
            .high = plane(wedge.high * view.ahead - view.left, 0, 1 + std::abs(wedge.high)),
            .screen = {},
            .screened = wedge.screened()};
  if (cull.screened)
    cull.screen = plane(wedge.normal.x() * view.ahead + wedge.normal.y() * view.left, -wedge.offset, 1);
  return cull;
}

}  // namespace meander::sonar

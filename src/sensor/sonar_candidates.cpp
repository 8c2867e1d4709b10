// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_candidates.hpp"

#include <algorithm>
#include <cmath>

namespace meander::sonar {
namespace {

constexpr std::size_t kBlock = 8;
constexpr double kRingWidth = 0.25;  ///< the order of the list is by rings of this width [m]
constexpr float kUnused = std::numeric_limits<float>::quiet_NaN();
/// Rounding of single precision in a half-plane's value, as a share of the list's radius; generous.
constexpr double kMargin = 4e-6;

/// The part of a wall within the disc, a little enlarged: what lies farther is out of range, and would need more
/// digits.
std::pair<Vec2, Vec2> near_part(const Wall& wall, const Vec2& center, double radius) {
  const Vec2 a = wall.a - center, b = wall.b - center, d = b - a;
  const double dd = d.squaredNorm(), ad = a.dot(d), r = 1.01 * radius;
  if (std::max(a.squaredNorm(), b.squaredNorm()) <= r * r) return {a, b};
  const double root = std::sqrt(std::max(0.0, ad * ad - dd * (a.squaredNorm() - r * r)));
  return {a + std::clamp((-ad - root) / dd, 0.0, 1.0) * d, a + std::clamp((-ad + root) / dd, 0.0, 1.0) * d};
}

void put(Lanes* lanes, std::size_t lane, double value) { lanes[lane / 4][lane % 4] = static_cast<float>(value); }

WallBlock wall_block(std::span<const Wall> walls, const Vec2& center, double radius) {
  WallBlock block;
  for (Lanes* lanes : {block.ax, block.ay, block.bx, block.by}) lanes[0] = lanes[1] = all(kUnused);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto [a, b] = near_part(walls[i], center, radius);
    put(block.ax, i, a.x()), put(block.ay, i, a.y());
    put(block.bx, i, b.x()), put(block.by, i, b.y());
  }
  return block;
}

DiscBlock disc_block(std::span<const Pole> poles, const Vec2& center, double radius) {
  DiscBlock block;
  for (Lanes* lanes : {block.x, block.y, block.radius}) lanes[0] = lanes[1] = all(kUnused);
  for (std::size_t i = 0; i < poles.size(); ++i) {
    const Vec2 p = poles[i].disc.center - center;
    const bool huge = poles[i].disc.radius > radius;  // too large for single precision: never culled
    put(block.x, i, huge ? 0 : p.x()), put(block.y, i, huge ? 0 : p.y());
    put(block.radius, i, huge ? kNever : poles[i].disc.radius);
  }
  return block;
}

template <class Piece, class Block, class Make>
void fill(std::span<const Piece> pieces, std::vector<Block>& blocks, const Make& make) {
  blocks.clear();
  for (std::size_t i = 0; i < pieces.size(); i += kBlock)
    blocks.push_back(make(pieces.subspan(i, std::min(kBlock, pieces.size() - i))));
}

double distance(const Wall& wall, const Vec2& p) { return distance_to_segment(p, wall.a, wall.b); }
double distance(const Pole& pole, const Vec2& p) { return (pole.disc.center - p).norm() - pole.disc.radius; }

}  // namespace

/// Sorts by rings around the centre, keeping the order within a ring, and notes the least distance from each block on.
template <class Piece>
void Candidates::sort_outward(const std::vector<Piece>& from, std::vector<Piece>& to, std::vector<double>& least) {
  const auto ring = [](double d) { return static_cast<std::size_t>(d / kRingWidth); };
  distance_.clear();
  rings_.assign(ring(radius_) + 3, 0);
  for (const Piece& piece : from) {
    distance_.push_back(std::clamp(distance(piece, center_), 0.0, radius_));
    ++rings_[ring(distance_.back()) + 1];
  }
  for (std::size_t i = 1; i < rings_.size(); ++i) rings_[i] += rings_[i - 1];
  order_.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) order_[rings_[ring(distance_[i])]++] = static_cast<std::uint32_t>(i);

  to.clear();
  for (const std::uint32_t i : order_) to.push_back(from[i]);
  least.assign((from.size() + kBlock - 1) / kBlock, kNever);
  for (std::size_t i = from.size(); i-- > 0;) {
    double& block = least[i / kBlock];
    block = std::min(block, distance_[order_[i]]);
    if (i % kBlock == 0 && i > 0) least[i / kBlock - 1] = block;
  }
}

std::uint16_t Candidates::kind_of(const Material& material) {
  const auto same = [&](const Material& m) {
    return m.echo == material.echo &&
           std::bit_cast<std::uint64_t>(m.specular_limit) == std::bit_cast<std::uint64_t>(material.specular_limit);
  };
  const auto known = std::find_if(materials_.begin(), materials_.end(), same);
  if (known == materials_.end()) {
    materials_.push_back(material);
    return static_cast<std::uint16_t>(materials_.size() - 1);
  }
  return static_cast<std::uint16_t>(known - materials_.begin());
}

void Candidates::gather(const ShapeIndex& index, const Vec2& center, double radius) {
  center_ = center;
  radius_ = radius;
  index.gather(center, radius, gathered_walls_, gathered_poles_);
  materials_.assign(1, Material{});  // of moving discs
  for (Wall& wall : gathered_walls_) wall.material = kind_of(index.material(wall.material));
  for (Pole& pole : gathered_poles_) pole.material = kind_of(index.material(pole.material));
  sort_outward(gathered_walls_, walls_, wall_distance_);
  sort_outward(gathered_poles_, poles_, pole_distance_);
  fill(walls(), wall_blocks_, [&](std::span<const Wall> w) { return wall_block(w, center, radius); });
  fill(poles(), pole_blocks_, [&](std::span<const Pole> p) { return disc_block(p, center, radius); });
}

void Candidates::set_moving(std::span<const Pole> moving, std::uint32_t except) {
  moving_.clear();
  for (const Pole& pole : moving) {
    if (pole.owner == except || (pole.disc.center - center_).norm() > radius_ + pole.disc.radius) continue;
    moving_.push_back(pole);
    moving_.back().material = 0;
  }
  fill(this->moving(), moving_blocks_, [&](std::span<const Pole> p) { return disc_block(p, center_, radius_); });
}

Cull Candidates::cull(const View& view, const Wedge& wedge) const {
  const Vec2 o = center_ - view.origin;
  Cull cull;
  const auto plane = [&](int i, Vec2 normal, double constant) {
    constant += normal.dot(o) + kMargin * radius_;
    cull.planes[i] = {all(static_cast<float>(normal.x())), all(static_cast<float>(normal.y())),
                      all(static_cast<float>(constant))};
  };
  plane(0, (view.left - wedge.low * view.ahead) / std::sqrt(1 + wedge.low * wedge.low), 0);
  plane(1, (wedge.high * view.ahead - view.left) / std::sqrt(1 + wedge.high * wedge.high), 0);
  plane(2, wedge.normal.x() * view.ahead + wedge.normal.y() * view.left, -wedge.offset);
  return cull;
}

unsigned Cull::may_touch(const WallBlock& block) const {
  unsigned touched = 0;
  for (int half = 0; half < 2; ++half) {
    LaneMask in = ~LaneMask{};
    for (const auto& [nx, ny, c] : planes) {
      const Lanes a = nx * block.ax[half] + (ny * block.ay[half] + c);
      const Lanes b = nx * block.bx[half] + (ny * block.by[half] + c);
      in &= greater(a, b) >= all(0);
    }
    touched |= bits(in) << (4 * half);
  }
  return touched;
}

unsigned Cull::may_touch(const DiscBlock& block) const {
  unsigned touched = 0;
  for (int half = 0; half < 2; ++half) {
    LaneMask in = ~LaneMask{};
    for (const auto& [nx, ny, c] : planes) in &= nx * block.x[half] + (ny * block.y[half] + c) >= -block.radius[half];
    touched |= bits(in) << (4 * half);
  }
  return touched;
}

}  // namespace meander::sonar

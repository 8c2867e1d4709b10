// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/link_doubt.hpp"

#include <algorithm>
#include <cmath>

namespace meander::topology {
namespace {

constexpr int kWidestArc = 9;  ///< whiskers; more go round a corner
const double kWidest = radians(60);
constexpr double kShortestPiece = 0.03;  ///< half of it [m]
constexpr int kFreePoints = 7;           ///< of a link that are felt for, ...
constexpr int kFelt = 5;                 ///< ... and so many must be within reach

/// Whiskers from `first` on, `count` of them, as pieces of wall.
void add_arc(int first, int count, int ring, double radius, double reach, const Pose2& pose,
             std::vector<WallPiece>& walls) {
  const double pitch = 2 * kPi / ring;
  const int pieces = (count + kWidestArc - 1) / kWidestArc;
  const double width = count * pitch / pieces;
  for (int piece = 0; piece < pieces; ++piece) {
    const double half = std::min(0.5 * width, kWidest);
    const double bearing = wrap_angle(pose.heading + (first - 0.5) * pitch + (piece + 0.5) * width);
    const SinCos t = sin_cos(bearing), w = sin_cos(half);
    // A straight wall at distance d bends the whiskers within acos(d / tip) of its normal.
    const double distance = std::max(radius, (radius + reach) * w.cos);
    walls.push_back(
        {pose.position() + distance * Vec2(t.cos, t.sin), bearing, std::max(kShortestPiece, distance * w.sin / w.cos)});
  }
}

}  // namespace

void felt_walls(std::span<const std::uint8_t> bent, double radius, double reach, const Pose2& pose,
                std::vector<WallPiece>& walls) {
  walls.clear();
  const auto ring = static_cast<int>(bent.size());
  // One whisker that misses between two that touch is taken as bent.
  const auto touches = [&](int i) {
    const auto at = [&](int k) { return bent[static_cast<std::size_t>(((k % ring) + ring) % ring)] != 0; };
    return at(i) || (at(i - 1) && at(i + 1));
  };
  int start = 0;
  while (start < ring && touches(start)) ++start;
  if (start == ring) return add_arc(0, ring, ring, radius, reach, pose, walls);
  for (int i = start + 1; i <= start + ring;) {
    int count = 0;
    while (i + count <= start + ring && touches(i + count)) ++count;
    if (count >= 2) add_arc(i, count, ring, radius, reach, pose, walls);
    i += count + 1;
  }
}

LinkDoubt::LinkDoubt(const DoubtOptions& options, double radius, double reach)
    : options_(options), radius_(radius), reach_(reach) {}

bool LinkDoubt::contradicts(const GrowingNet& net, const Vec2& a, const Vec2& b, int cell, int other) const {
  const int ring = net.metric().touch();
  return std::any_of(walls_.begin(), walls_.end(), [&](const WallPiece& wall) {
    const SinCos t = sin_cos(wall.bearing);
    const Vec2 normal(t.cos, t.sin);
    const double da = (a - wall.middle).dot(normal), db = (b - wall.middle).dot(normal);
    if (da * db >= 0 || std::min(std::abs(da), std::abs(db)) < options_.clear) return false;
    const Vec2 crossing = a + da / (da - db) * (b - a);
    if ((crossing - wall.middle).norm() > wall.half_length) return false;
    const auto sector = static_cast<int>(std::lround(wall.bearing / (2 * kPi) * ring) + ring) % ring;
    const auto expected = [&](int c) { return static_cast<double>(net.cells().senses(c)[sector]); };
    return expected(cell) <= options_.surprise && expected(other) <= options_.surprise;
  });
}

bool LinkDoubt::feels_free(const Pose2& pose, const Vec2& a, const Vec2& b) const {
  if (!walls_.empty()) return false;
  int felt = 0;
  for (int i = 0; i < kFreePoints; ++i) {
    const Vec2 point = a + (i + 0.5) / kFreePoints * (b - a);
    felt += (point - pose.position()).norm() <= radius_ + reach_;
  }
  return felt >= kFelt;
}

void LinkDoubt::judge_link(GrowingNet& net, const Pose2& pose, int cell, const Link& link) {
  const Vec2 &a = net.cells()[cell].position, &b = net.cells()[link.to].position;
  Link judged = link;
  if (contradicts(net, a, b, cell, link.to))
    judged.doubt += 1;
  else if (link.doubt > 0 && feels_free(pose, a, b))
    judged.doubt = std::max(0.0, link.doubt - options_.relief);
  else
    return;
  judged.doubt = std::min(judged.doubt, options_.suspend);
  if (judged.doubt >= options_.suspend) judged.suspended = true;
  if (judged.doubt == 0) judged.suspended = false;
  net.cells().connect(cell, link.to, judged);
}

void LinkDoubt::judge(GrowingNet& net, const Pose2& pose, std::span<const std::uint8_t> bent, std::int64_t sample) {
  if (options_.suspend == 0 || sample < options_.age) return;
  felt_walls(bent, radius_, reach_, pose, walls_);
  near_.clear();
  net.around(pose.position(), options_.reach, [&](int cell) {
    if ((net.cells()[cell].position - pose.position()).norm() <= options_.reach) near_.push_back(cell);
  });
  std::sort(near_.begin(), near_.end());
  for (const int cell : near_)
    for (std::size_t i = 0; i < net.cells()[cell].links.size(); ++i) {
      const Link link = net.cells()[cell].links[i];
      // Once each: by its smaller end, or by the only one that is near.
      if (link.to > cell || !std::binary_search(near_.begin(), near_.end(), link.to)) judge_link(net, pose, cell, link);
    }
}

}  // namespace meander::topology

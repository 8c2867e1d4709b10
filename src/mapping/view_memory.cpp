// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/view_memory.hpp"

#include <cmath>

#include <algorithm>

#include "mapping/log_odds.hpp"

namespace meander {
namespace {

constexpr std::size_t kMostOpinions = std::size_t{1} << 28;  ///< a byte each

}  // namespace

ViewMemory::ViewMemory(const FusionOptions& options, int size, double resolution)
    : cells_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)),
      sectors_(std::max(1, static_cast<int>(std::lround(2 * kPi / options.view_bearing)))),
      rings_(1 + static_cast<int>(0.71 * size * resolution / options.view_range)),
      per_radian_(static_cast<float>(sectors_ / (2 * kPi))),
      per_metre_(static_cast<float>(1 / options.view_range)),
      blend_(static_cast<float>(options.view_blend)),
      unit_(log_odds_of(options.certainty) / 127),
      remember_(options.remember_views),
      last_(cells_, -1) {
  const std::size_t opinions = cells_ * static_cast<std::size_t>(sectors_ * rings_);
  if (opinions > kMostOpinions)
    fail("{} views of each of {} cells are more than can be kept: a larger view_bearing or view_range expected",
         sectors_ * rings_, cells_);
  opinion_.assign(opinions, kNone);
}

float ViewMemory::increment(std::size_t cell, int view, float log_odds) {
  std::int8_t& opinion = opinion_[static_cast<std::size_t>(view) * cells_ + cell];
  if (!remember_ && last_[cell] != view) opinion = kNone;
  last_[cell] = static_cast<std::int16_t>(view);
  const bool first = opinion == kNone;
  const float before = first ? 0 : static_cast<float>(opinion);
  const float now = before + (first ? 1 : blend_) * (log_odds / unit_ - before);
  opinion = static_cast<std::int8_t>(std::lrint(now));
  return (static_cast<float>(opinion) - before) * unit_;
}

void ViewMemory::forget(std::size_t cell) {
  for (std::size_t at = cell; at < opinion_.size(); at += cells_) opinion_[at] = kNone;
  last_[cell] = -1;
}

}  // namespace meander

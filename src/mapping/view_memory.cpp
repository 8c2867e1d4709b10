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
      unit_(log_odds_of(options.certainty) / kMost),
      remember_(options.remember_views),
      sum_(cells_, 0),
      last_(remember_ ? 0 : cells_, -1) {
  const std::size_t opinions = cells_ * static_cast<std::size_t>(sectors_ * rings_);
  if (opinions > kMostOpinions)
    fail("{} views of each of {} cells are more than can be kept: a larger view_bearing or view_range expected",
         sectors_ * rings_, cells_);
  opinion_.assign(opinions, kNone);
}

float ViewMemory::increment(std::size_t cell, int view, float log_odds) {
  std::int8_t& opinion = opinion_[static_cast<std::size_t>(view) * cells_ + cell];
  if (!remember_) {
    if (last_[cell] != view) opinion = kNone;
    last_[cell] = view;
  }
  const bool first = opinion == kNone;
  const float before = first ? 0 : static_cast<float>(opinion);
  const float now = before + (first ? 1 : blend_) * (log_odds / unit_ - before);
  const int known = first ? 0 : opinion;
  opinion = static_cast<std::int8_t>(std::lrint(now));
  const std::int32_t was = std::clamp(sum_[cell], -kMost, kMost);
  // Opinions that are forgotten are never taken back: their sum is kept within the limit as evidence is.
  sum_[cell] = (remember_ ? sum_[cell] : was) + opinion - known;
  return static_cast<float>(std::clamp(sum_[cell], -kMost, kMost) - was) * unit_;
}

void ViewMemory::forget(std::size_t cell) {
  for (std::size_t at = cell; at < opinion_.size(); at += cells_) opinion_[at] = kNone;
  sum_[cell] = 0;
  if (!remember_) last_[cell] = -1;
}

}  // namespace meander

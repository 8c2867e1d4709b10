// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/view_memory.hpp"

#include <cmath>

#include <algorithm>
#include <utility>

#include "mapping/log_odds.hpp"

namespace meander {
namespace {

constexpr std::size_t kMostOpinions = std::size_t{1} << 28;  ///< a byte each

}  // namespace

ViewMemory::ViewMemory(const FusionOptions& options, int size, double resolution, bool keeps)
    : cells_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)),
      sectors_(std::max(1, static_cast<int>(std::lround(2 * kPi / options.view_bearing)))),
      rings_(1 + static_cast<int>(0.71 * size * resolution / options.view_range)),
      per_radian_(static_cast<float>(sectors_ / (2 * kPi))),
      per_metre_(static_cast<float>(1 / options.view_range)),
      blend_(static_cast<float>(options.view_blend)),
      unit_(log_odds_of(options.certainty) / kMost),
      remember_(options.remember_views),
      sum_(cells_, 0),
      ever_(keeps && remember_ ? cells_ : 0, 0),
      last_(remember_ ? 0 : cells_, -1) {
  const std::size_t opinions = cells_ * static_cast<std::size_t>(sectors_ * rings_);
  if (opinions > kMostOpinions)
    fail("{} views of each of {} cells are more than can be kept: a larger view_bearing or view_range expected",
         sectors_ * rings_, cells_);
  opinion_.assign(opinions, kNone);
  if (!ever_.empty()) kept_.emplace(sectors_ * rings_);
}

/// The opinion with a scan more.
std::int8_t ViewMemory::refined(std::int8_t before, float log_odds) const {
  const float known = before == kNone ? 0 : static_cast<float>(before);
  return static_cast<std::int8_t>(std::lrint(known + (before == kNone ? 1 : blend_) * (log_odds / unit_ - known)));
}

/// What the sum tells more than before.
float ViewMemory::add(std::int32_t& sum, int more) const {
  const std::int32_t was = std::clamp(sum, -kMost, kMost);
  sum = std::clamp(sum + more, -kMostSum, kMostSum);
  return static_cast<float>(std::clamp(sum, -kMost, kMost) - was) * unit_;
}

float ViewMemory::increment(std::size_t at, int view, float log_odds) {
  std::int8_t& opinion = opinion_[static_cast<std::size_t>(view) * cells_ + at];
  if (!remember_) {
    if (last_[at] != view) opinion = kNone;
    last_[at] = view;
    // Opinions that are forgotten are never taken back: their sum is kept within the limit as evidence is.
    sum_[at] = std::clamp(sum_[at], -kMost, kMost);
  }
  const std::int8_t before = std::exchange(opinion, refined(opinion, log_odds));
  return add(sum_[at], opinion - (before == kNone ? 0 : before));
}

ViewMemory::Increments ViewMemory::increments(std::size_t at, Cell cell, int view, float log_odds) {
  if (!kept_) {
    const float both = increment(at, view, log_odds);
    return {both, both};
  }
  std::int8_t& opinion = opinion_[static_cast<std::size_t>(view) * cells_ + at];
  const std::int8_t before = opinion, ever = before == kNone ? kept_->opinion(cell, view) : before;
  opinion = refined(ever, log_odds);
  return {add(sum_[at], opinion - (before == kNone ? 0 : before)),
          add(ever_[at], opinion - (ever == kNone ? 0 : ever))};
}

void ViewMemory::set_free(std::size_t at) {
  sum_[at] = std::min(sum_[at], -kMost);
  if (kept_) ever_[at] = std::min(ever_[at], -kMost);
}

void ViewMemory::replace(std::size_t at, Cell left, Cell entered) {
  int view = 0;
  for (std::size_t i = at; i < opinion_.size(); i += cells_, ++view) {
    if (kept_ && opinion_[i] != kNone) kept_->keep_opinion(left, view, opinion_[i]);
    opinion_[i] = kNone;
  }
  sum_[at] = 0;
  if (!remember_) last_[at] = -1;
  if (!kept_) return;
  if (ever_[at] != 0) kept_->keep_sum(left, ever_[at]);
  ever_[at] = kept_->sum(entered);
}

void ViewMemory::clear() {
  std::fill(opinion_.begin(), opinion_.end(), kNone);
  std::fill(sum_.begin(), sum_.end(), 0);
  std::fill(ever_.begin(), ever_.end(), 0);
  std::fill(last_.begin(), last_.end(), -1);
  if (kept_) kept_->clear();
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/place_scores.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

constexpr std::size_t kLast = 1000;  ///< samples of error_last

bool in_sight(const Sim& sim, const Vec2& from, const Vec2& to) {
  const double distance = (to - from).norm();
  return distance == 0 || !sim.scene().walls().cast(from, (to - from) / distance, distance);
}

}  // namespace

PlaceScores::PlaceScores(const Sim& sim, const PlaceScoreOptions& options)
    : options_(options), before_(sim.state().pose_world.position()) {
  validate(options);
}

void PlaceScores::add(const Sim& sim, const Pose2& believed, const PlaceClaim& claim) {
  truth_.push_back(before_);
  before_ = sim.state().pose_world.position();
  believed_.push_back(believed.position());
  if (claim.sample >= 0 && claim.sample < static_cast<std::int64_t>(truth_.size())) judge(sim, claim);
}

void PlaceScores::judge(const Sim& sim, const PlaceClaim& claim) {
  const Vec2 was = truth_[static_cast<std::size_t>(claim.sample)];
  TruePlace& place = places_[claim.place];
  const bool known = place.hits > 0 && claim.sample - claim.born >= options_.age;
  const bool near = known && (place.position - was).norm() <= options_.within;
  claimed_ += known;
  right_ += near && in_sight(sim, was, place.position);
  const auto square = std::pair(static_cast<int>(std::floor(was.x() / options_.bin)),
                                static_cast<int>(std::floor(was.y() / options_.bin)));
  const auto [first, fresh] = first_seen_.try_emplace(square, claim.sample);
  if (!fresh && claim.sample - first->second >= options_.age) {
    ++returns_;
    recognised_ += near;
  }
  place.hits = std::min(place.hits + 1, options_.hits);
  place.position += (was - place.position) / place.hits;
}

std::optional<Vec2> PlaceScores::true_place(std::uint64_t place) const {
  const auto found = places_.find(place);
  return found == places_.end() ? std::nullopt : std::optional(found->second.position);
}

double PlaceScores::map_error(std::span<const MapPlace> places) const {
  double square = 0;
  int known = 0;
  for (const MapPlace& place : places)
    if (const auto truth = true_place(place.place)) {
      square += (place.position - *truth).squaredNorm();
      ++known;
    }
  return known > 0 ? std::sqrt(square / known) : 0;
}

double PlaceScores::aligned_error() const {
  // The turn and shift of least squares in the plane: with both sets about their means, the angle of the sum of the
  // products a* b of complex numbers.
  const auto n = static_cast<double>(truth_.size());
  Vec2 mean_truth(0, 0), mean_believed(0, 0);
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    mean_truth += truth_[i] / n;
    mean_believed += believed_[i] / n;
  }
  double dot = 0, turned = 0, square = 0;
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const Vec2 a = believed_[i] - mean_believed, b = truth_[i] - mean_truth;
    dot += a.dot(b);
    turned += cross(a, b);
    square += a.squaredNorm() + b.squaredNorm();
  }
  return std::sqrt(std::max(0.0, square - 2 * std::sqrt(dot * dot + turned * turned)) / n);
}

PlaceSummary PlaceScores::summary() const {
  PlaceSummary sum;
  sum.samples = static_cast<int>(truth_.size());
  if (truth_.empty()) return sum;
  const std::size_t last = std::min(kLast, truth_.size());
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const double error = (truth_[i] - believed_[i]).norm();
    sum.error_mean += error / static_cast<double>(truth_.size());
    sum.error_max = std::max(sum.error_max, error);
    if (i + last >= truth_.size()) sum.error_last += error / static_cast<double>(last);
  }
  sum.error_aligned = aligned_error();
  sum.recall = returns_ > 0 ? static_cast<double>(recognised_) / returns_ : 0;
  sum.precision = claimed_ > 0 ? static_cast<double>(right_) / claimed_ : 0;
  return sum;
}

}  // namespace meander

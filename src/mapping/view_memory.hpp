// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "mapping/fusion.hpp"
#include "mapping/kept_views.hpp"

namespace meander {

/// [CN+] Scans taken from about the same place are no independent observations, as eq. (4) supposes: a sonar that is
/// fooled there is fooled every time. So each cell keeps one opinion per view, a view being the bearing and the
/// distance it is seen at; scans of the same view refine their opinion, and only opinions of different views add up.
class ViewMemory {
 public:
  /// `keeps`: what views said of places outlives these in the window.
  ViewMemory(const FusionOptions& options, int size, double resolution, bool keeps);

  int view(float bearing, float range) const {
    const auto sector = static_cast<int>((bearing + kTurn) * per_radian_) % sectors_;
    const auto ring = static_cast<int>(range * per_metre_);
    return (ring < rings_ ? ring : rings_ - 1) * sectors_ + sector;
  }
  /// What a scan adds to the evidence on the cell that lies at `at` in the window, which stays within the limit: the
  /// opinions add up beyond it, so that a view which changes its mind takes back no more than it had said.
  float increment(std::size_t at, int view, float log_odds);
  /// The same, and for who keeps evidence of everywhere what it adds to that.
  struct Increments {
    float window = 0, everywhere = 0;
  };
  Increments increments(std::size_t at, Cell cell, int view, float log_odds);
  /// The robot stands there.
  void set_free(std::size_t at);
  /// Another cell of the plane takes the place `at` in the window.
  void replace(std::size_t at, Cell left, Cell entered);
  void clear();
  /// Throws Error when no more can be kept.
  void check_room() const {
    if (kept_) kept_->check_room();
  }
  std::size_t bytes() const {
    return opinion_.capacity() + 4 * (sum_.capacity() + ever_.capacity() + last_.capacity()) +
           (kept_ ? kept_->bytes() : 0);
  }

 private:
  static constexpr std::int8_t kNone = KeptViews::kNone;
  static constexpr std::int32_t kMost = 127;  ///< the limit, of opinions and of what is told of their sum
  /// As much as three sure views: what many have held free is noticed in a few more, and one alone still decides
  /// nothing.
  static constexpr std::int32_t kMostSum = 3 * kMost;
  static constexpr float kTurn = static_cast<float>(2 * kPi);

  std::int8_t refined(std::int8_t before, float log_odds) const;
  float add(std::int32_t& sum, int more) const;

  std::size_t cells_;
  int sectors_, rings_;
  float per_radian_, per_metre_;
  float blend_, unit_;  ///< opinions are kept in units of `unit_`, kMost of them the limit
  bool remember_;
  std::optional<KeptViews> kept_;
  std::vector<std::int8_t> opinion_;  ///< since the cell is in the window; cell by cell within view by view
  std::vector<std::int32_t> sum_;     ///< of the opinions on each cell
  std::vector<std::int32_t> ever_;    ///< the same with those of before it was in the window, where these are kept
  std::vector<std::int32_t> last_;    ///< view of the cell's last scan, where views are not remembered
};

}  // namespace meander

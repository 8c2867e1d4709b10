// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "mapping/fusion.hpp"

namespace meander {

/// [CN+] Scans taken from about the same place are no independent observations, as eq. (4) supposes: a sonar that is
/// fooled there is fooled every time. So each cell keeps one opinion per view, a view being the bearing and the
/// distance it is seen at; scans of the same view refine their opinion, and only opinions of different views add up.
class ViewMemory {
 public:
  ViewMemory(const FusionOptions& options, int size, double resolution);

  int view(float bearing, float range) const {
    const auto sector = static_cast<int>((bearing + kTurn) * per_radian_) % sectors_;
    const auto ring = static_cast<int>(range * per_metre_);
    return (ring < rings_ ? ring : rings_ - 1) * sectors_ + sector;
  }
  /// What the scan adds to the evidence on the cell, which stays within the limit: the opinions add up without one, so
  /// that a view which changes its mind takes back no more than it had said.
  float increment(std::size_t cell, int view, float log_odds);
  /// The robot stands there.
  void set_free(std::size_t cell) { sum_[cell] = std::min(sum_[cell], -kMost); }
  void forget(std::size_t cell);
  std::size_t bytes() const { return opinion_.capacity() + 4 * (sum_.capacity() + last_.capacity()); }

 private:
  static constexpr std::int8_t kNone = -128;
  static constexpr std::int32_t kMost = 127;  ///< the limit, of opinions and of what is told of their sum
  static constexpr float kTurn = static_cast<float>(2 * kPi);

  std::size_t cells_;
  int sectors_, rings_;
  float per_radian_, per_metre_;
  float blend_, unit_;  ///< opinions are kept in units of `unit_`, kMost of them the limit
  bool remember_;
  std::vector<std::int8_t> opinion_;  ///< cell by cell within view by view
  std::vector<std::int32_t> sum_;     ///< of the opinions on each cell
  std::vector<std::int32_t> last_;    ///< view of the cell's last scan, where views are not remembered
};

}  // namespace meander

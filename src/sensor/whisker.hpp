// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>

#include "base/fields.hpp"
#include "base/random.hpp"
#include "robot/platform.hpp"
#include "sensor/scene.hpp"

namespace meander {

/// Whiskers: straight rods that point outwards from a ring and tell only whether they are bent.
struct WhiskerOptions {
  double reach = 0.15;        ///< beyond their roots [m]
  double false_alarm = 0.01;  ///< chance that a free one tells a contact
  double miss = 0.02;         ///< chance that a bent one tells none
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WhiskerOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"reach", "m", "length of a whisker", 0, 10}, o.reach);
  visit(Field{"false_alarm", "", "chance that a free whisker tells a contact", 0, 1}, o.false_alarm);
  visit(Field{"miss", "", "chance that a bent whisker tells none", 0, 1}, o.miss);
}

/// Copying it forks it.
class WhiskerRing {
 public:
  WhiskerRing(const RingLayout& layout, const WhiskerOptions& options, std::uint64_t seed);
  /// 1 where a whisker tells a contact, in ring order; `bent` has layout.count entries. The disc of owner `self` is not
  /// met.
  void read(const Scene& scene, const Pose2& pose_world, std::uint32_t self, std::span<std::uint8_t> bent);
  void add_to(Hash& hash) const { stream_.add_to(hash); }

 private:
  RingLayout layout_;
  WhiskerOptions options_;
  Stream stream_;
};

}  // namespace meander

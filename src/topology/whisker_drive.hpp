// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/contracts.hpp"
#include "robot/platform.hpp"

namespace meander::topology {

/// Which whiskers tell of something solid: bent now, and not all alone, or bent before too. (One in a hundred free
/// whiskers tells a contact.)
class WhiskerContacts {
 public:
  explicit WhiskerContacts(int whiskers);
  /// `went`: the bearing [rad] in which the robot was sent, if it was. When it did not move a corner between two
  /// whiskers holds it there. Throws ArgumentError when the ring has another size.
  void update(const Observation& seen, std::optional<double> went);
  std::span<const std::uint8_t> solid() const { return solid_; }
  bool any() const { return any_; }
  /// Bearing [rad] of whisker i.
  double bearing(int whisker) const { return whisker * pitch_; }
  /// Is the way at this bearing free of contacts within `half_width` [rad] of it?
  bool free(double bearing, double half_width) const;
  /// The free bearing nearest to the wanted one, at most `most` [rad] away; where none is, one with half the room, and
  /// so on. Sets `found` when there is one.
  bool nearest_free(double wanted, double half_width, double most, double& found) const;
  /// Mean bearing of the contacts; 0 when there is none.
  double middle() const;

 private:
  double pitch_;
  std::vector<std::uint8_t> before_, solid_;
  std::vector<int> held_;  ///< samples for which a corner is still believed there
  bool any_ = false;
};

struct WhiskerDriveOptions {
  double half_width = 0.7853981633974483;   ///< contacts so near to the way block it [rad]
  double most_detour = 1.8325957145940461;  ///< slides along what it touches up to this far from the wanted way [rad]
  double progress = 0.10;                   ///< trapped when it comes no nearer by this [m] ...
  double patience = 12;                     ///< ... for so long [s]
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WhiskerDriveOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"half_width", "rad", "contacts so near to the way block it", 0, 3.2}, o.half_width);
  visit(Field{"most_detour", "rad", "slides up to this far from the wanted way", 0, 3.2}, o.most_detour);
  visit(Field{"progress", "m", "trapped when it comes no nearer by this", 0, 100}, o.progress);
  visit(Field{"patience", "s", "for so long", 0, 1e6}, o.patience);
}

/// Drives an omnidirectional robot straight to its subgoal and slides along what its whiskers touch.
Navigator whisker_drive(const Platform& platform, const WhiskerDriveOptions& options = {});

}  // namespace meander::topology

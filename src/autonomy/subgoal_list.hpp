// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "base/fields.hpp"
#include "robot/contracts.hpp"

namespace meander {

/// What a guide does when the navigator says that it is trapped.
enum class WhenTrapped { stop, skip, insist };
template <>
struct EnumNames<WhenTrapped> {
  static constexpr std::pair<WhenTrapped, const char*> entries[] = {
      {WhenTrapped::stop, "stop"}, {WhenTrapped::skip, "skip"}, {WhenTrapped::insist, "insist"}};
};

struct SubgoalListOptions {
  double hand_over = 0;  ///< [m]
  WhenTrapped when_trapped = WhenTrapped::stop;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SubgoalListOptions>
void fields(Options& o, Visitor&& visit) {
  visit(
      Field{
          "hand_over", "m",
          "go on to the next subgoal when this near, so that the robot need not slow down; 0: the subgoal's tolerance",
          0, 100},
      o.hand_over);
  visit(Field{"when_trapped", "", "stop, skip to the next subgoal, or insist on this one"}, o.when_trapped);
}

/// One subgoal after the other. A subgoal counts as reached when the robot's centre is within its tolerance (or within
/// hand_over, except of the last) or when the navigator says arrived. Success when all were reached. Throws
/// ArgumentError when the list is empty or a number is not finite.
Guide subgoal_list(std::vector<Subgoal> subgoals, const SubgoalListOptions& options = {});

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/fields.hpp"
#include "geometry/pose.hpp"
#include "topology/growing_net.hpp"

namespace meander::topology {

/// Links that contacts speak against. [Z+] Rule (8) forgets links of cells that still win; where a wall was added other
/// cells win, and the old links would stay for ever. A surprising contact suspends a link; driving it, or feeling that
/// the way is free, brings it back.
struct DoubtOptions {
  double suspend = 2;     ///< a link is suspended at so many contacts against it; 0: never
  double relief = 0.5;    ///< what a sample that feels the way free takes away
  double reach = 0.75;    ///< links of cells this near are judged [m]
  double surprise = 0.4;  ///< a contact that a cell of the link expects more than this is none
  double clear = 0.05;    ///< both cells of a contradicted link are at least this far from the wall's line [m]
  int age = 60;           ///< samples before anything is judged
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DoubtOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"suspend", "", "contacts against a link that suspend it; 0: links are never suspended", 0, 1e6},
        o.suspend);
  visit(Field{"relief", "", "what a sample that feels the way free takes away", 0, 1e6}, o.relief);
  visit(Field{"reach", "m", "links of cells this near to the robot are judged", 0, 100}, o.reach);
  visit(Field{"surprise", "", "contacts that a cell expects more than this are no surprise", 0, 1}, o.surprise);
  visit(Field{"clear", "m", "both cells must be this far from the line of the wall", 0, 100}, o.clear);
  visit(Field{"age", "", "samples before anything is judged", 0, 1e9}, o.age);
}

/// A piece of wall that the whiskers felt, in the frame of the map.
struct WallPiece {
  Vec2 middle{0, 0};
  double bearing = 0;      ///< from the robot to it [rad]
  double half_length = 0;  ///< [m], across the bearing
};

/// The pieces of wall behind arcs of two or more bent whiskers. `radius` of the ring of roots, `reach` of the whiskers
/// beyond it [m].
void felt_walls(std::span<const std::uint8_t> bent, double radius, double reach, const Pose2& pose,
                std::vector<WallPiece>& walls);

class LinkDoubt {
 public:
  LinkDoubt(const DoubtOptions& options, double radius, double reach);
  /// Judges the links near the robot by what its whiskers feel.
  void judge(GrowingNet& net, const Pose2& pose, std::span<const std::uint8_t> bent, std::int64_t sample);

 private:
  bool contradicts(const GrowingNet& net, const Vec2& a, const Vec2& b, int cell, int other) const;
  bool feels_free(const Pose2& pose, const Vec2& a, const Vec2& b) const;
  void judge_link(GrowingNet& net, const Pose2& pose, int cell, const Link& link);

  DoubtOptions options_;
  double radius_, reach_;
  std::vector<WallPiece> walls_;
  std::vector<int> near_;  ///< scratch
};

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "polar/polar_navigator.hpp"
#include "script/kit_function.hpp"
#include "script/kit_options.hpp"
#include "script/numbers.hpp"

namespace meander::script {

// Tables that parts of a polar navigator written in Lua get and give. Rings and sectors count from 1: the centre's ring
// is 1, the target's sector is 1.

/// A ring, for weights of one's own.
struct PolarRingView {
  int ring = 1, rings = 1, sectors = 1;
  double radius = 0, inner = 0, outer = 0, spacing = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarRingView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"ring", "", "which, the centre is 1"}, o.ring);
  visit(Field{"rings", "", "how many there are"}, o.rings);
  visit(Field{"sectors", "", "units on it"}, o.sectors);
  visit(Field{"radius", "m", "its radius"}, o.radius);
  visit(Field{"inner", "m", "radius of the next ring inwards"}, o.inner);
  visit(Field{"outer", "m", "radius of the next ring outwards, its own for the outermost"}, o.outer);
  visit(Field{"spacing", "rad", "between sectors"}, o.spacing);
}

/// The answer: weights of the neighbours, and how much is lost.
struct PolarRingWeights {
  Required<double> inward, outward, lateral;
  double inward_diagonal = 0, outward_diagonal = 0;
  Required<double> leak;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarRingWeights>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"inward", "", "weight of the next unit inwards"}, o.inward);
  visit(Field{"outward", "", "weight of the next unit outwards"}, o.outward);
  visit(Field{"lateral", "", "weight of each neighbour on the ring"}, o.lateral);
  visit(Field{"inward_diagonal", "", "weight of each neighbour's inner neighbour"}, o.inward_diagonal);
  visit(Field{"outward_diagonal", "", "weight of each neighbour's outer neighbour"}, o.outward_diagonal);
  visit(Field{"leak", "", "how much less than their weighted sum a unit gets: total = weights + leak"}, o.leak);
}

/// A candidate, for an objective of one's own.
struct PolarCandidateView {
  double v = 0, w = 0, x = 0, y = 0, heading = 0, distance = 0, heading_error = 0;
  int samples = 0, hard = 0, soft = 0;
  bool near = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarCandidateView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"v", "m/s", "forward speed"}, o.v);
  visit(Field{"w", "rad/s", "turning rate"}, o.w);
  visit(Field{"x", "m", "where it would come to stand, in the map's frame"}, o.x);
  visit(Field{"y", "m", "the same"}, o.y);
  visit(Field{"heading", "rad", "the same"}, o.heading);
  visit(Field{"distance", "m", "from there to the subgoal"}, o.distance);
  visit(Field{"heading_error", "rad", "from facing the subgoal there"}, o.heading_error);
  visit(Field{"samples", "", "of the trajectory"}, o.samples);
  visit(Field{"hard", "", "samples nearer to a point than the hard margin"}, o.hard);
  visit(Field{"soft", "", "samples nearer than the soft margin"}, o.soft);
  visit(Field{"near", "", "the robot is near a point now"}, o.near);
}

/// The map at its equilibrium, for a subgoal rule of one's own.
struct PolarStateView {
  int rings = 0, sectors = 0;
  double target = 0;
  int target_ring = 0;
  std::optional<int> previous;
  std::vector<double> radii, bearings;
  Matrix activation;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarStateView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"rings", "", "how many there are"}, o.rings);
  visit(Field{"sectors", "", "how many there are"}, o.sectors);
  visit(Field{"target", "m", "distance of the target, which lies in sector 1"}, o.target);
  visit(Field{"target_ring", "", "ring of the target's unit"}, o.target_ring);
  visit(Field{"previous", "", "sector of the last direction"}, o.previous);
  visit(Field{"radii", "m", "of the rings"}, o.radii);
  visit(Field{"bearings", "rad", "of the sectors, in the map's frame"}, o.bearings);
  visit(Field{"activation", "", "decadic logarithm, a row per ring; -400 where there is none"}, o.activation);
}

/// Parts of one's own, as functions.
struct PolarOwnTable {
  std::optional<Function> weights, objective, subgoal;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarOwnTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"weights", "",
              "function(ring): weights {inward =, outward =, lateral =, leak =, inward_diagonal =, outward_diagonal =} "
              "of a ring, "
              "which has ring, rings, sectors, radius, inner, outer, spacing"},
        o.weights);
  visit(Field{"objective", "",
              "function(candidate): its cost; the least is taken; a candidate has v, w, x, y, heading, distance, "
              "heading_error, "
              "samples, hard, soft, near"},
        o.objective);
  visit(Field{"subgoal", "",
              "function(map): ring and sector of the subgoal, or nil: no way; a map has rings, sectors, target, "
              "target_ring, "
              "previous, radii, bearings, activation"},
        o.subgoal);
}

PolarCandidateView candidate_view(const MotionCandidate& candidate);
PolarParts polar_parts(const PolarOwnTable& own);
/// In the map's frame [rad].
std::vector<double> sector_bearings(const PolarLayout& layout);
/// The activation's logarithms, a row per ring.
Matrix log_activation(const PolarLayout& layout, const PolarSolver& solver);

}  // namespace meander::script

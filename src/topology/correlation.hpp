// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"
#include "geometry/pose.hpp"
#include "topology/growing_net.hpp"

namespace meander::topology {

/// Keeps the robot localised by its map ([Z] section 3-4 leaves the method to a paper that cannot be had; this is
/// ours).
struct CorrelationOptions {
  double reach = 1.5;   ///< cells so far from where the robot believes to be are compared [m]
  int age = 60;         ///< cells younger than this [samples] are not: they would confirm the robot's own error
  double accept = 0.8;  ///< largest distance of the best cell that counts
  double turn_step = 0.05235987755982989;  ///< headings are tried at multiples of this [rad]
  int turns = 5;                           ///< so many to each side; 0: headings are not corrected
  double turn_cost = 0.02;                 ///< of a tried heading, times the square of its number
  double gain = 0.05;                      ///< share of the way to the best cell
  double turn_gain = 0.02;                 ///< share of the best turn
  double dead_zone = 0.1;                  ///< no correction of the position below this [m]
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, CorrelationOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"reach", "m", "cells within this of the believed place are compared", 1e-3, 100}, o.reach);
  visit(Field{"age", "", "samples that a cell must be old", 0, 1e9}, o.age);
  visit(Field{"accept", "", "largest distance of the best cell that counts", 0, 100}, o.accept);
  visit(Field{"turn_step", "rad", "headings are tried at multiples of this", 1e-4, 1}, o.turn_step);
  visit(Field{"turns", "", "headings tried to each side; 0: the heading is not corrected", 0, 60}, o.turns);
  visit(Field{"turn_cost", "", "cost of a tried heading, times the square of its number", 0, 100}, o.turn_cost);
  visit(Field{"gain", "", "share of the way to the best cell that is corrected; 0: no correction", 0, 1}, o.gain);
  visit(Field{"turn_gain", "", "share of the best turn that is corrected", 0, 1}, o.turn_gain);
  visit(Field{"dead_zone", "m", "nearer cells do not correct the position", 0, 100}, o.dead_zone);
}

/// What the map says of the robot's pose.
struct Correction {
  Vec2 shift{0, 0};     ///< to add to the believed position [m]
  double turn = 0;      ///< to add to the believed heading [rad]
  int cell = -1;        ///< that matched; -1: none
  double distance = 0;  ///< of that cell
};

/// Rings of touch (smoothed) and light in the robot's own frame.
struct SenseRings {
  std::span<const float> touch, light;
};

class Correlation {
 public:
  Correlation(const CorrelationOptions& options, const SenseMetric& metric);
  Correction correct(const GrowingNet& net, const Pose2& pose, const SenseRings& rings, std::int64_t sample);

 private:
  void turn_senses(const SenseRings& rings, double heading);

  CorrelationOptions options_;
  SenseMetric metric_;
  std::vector<float> turned_;  ///< a row of senses per tried heading
};

/// Rings as a row of senses in the frame of the map; the row has the metric's stride.
void senses_of(const SenseRings& rings, double heading, std::span<float> row);

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <vector>

#include "polar/layout_organiser.hpp"
#include "polar/motion_control.hpp"
#include "polar/polar_layout.hpp"
#include "polar/polar_solver.hpp"
#include "polar/prediction.hpp"
#include "polar/sonar_memory.hpp"
#include "polar/subgoal_readout.hpp"
#include "polar/trap_escapes.hpp"

namespace meander {

/// full: with all remedies; paper: without those that go beyond [LM99].
enum class PolarMode { full, paper };
template <>
struct EnumNames<PolarMode> {
  static constexpr std::pair<PolarMode, const char*> entries[] = {{PolarMode::full, "full"},
                                                                  {PolarMode::paper, "paper"}};
};

struct PolarMapOptions {
  PolarLayoutOptions layout;
  PolarWeights weights = PolarWeights::finite_volume;
  double kappa = 30;
  double margin = 0.05;
  double narrow_margin = 0.02;
  double merge = 0.03;
  LayoutOrganiserOptions organising;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarMapOptions>
void fields(Options& o, Visitor&& visit) {
  fields(o.layout, visit);
  visit(Field{"weights", "", "weights of the connections"}, o.weights);
  visit(Field{"kappa", "1/m", "how fast activation decays along a way, with finite volumes", 0.1, 200}, o.kappa);
  visit(Field{"margin", "m", "units nearer to a point than the robot's radius and this are obstructed", 0, 10},
        o.margin);
  visit(Field{"narrow_margin", "m", "the same, when no activation reaches the robot otherwise", 0, 10},
        o.narrow_margin);
  visit(Field{"merge", "m", "remembered points in the same square of this size count once; 0: all count", 0, 1},
        o.merge);
  visit(Field{"organising", "", "how a self-organising layout learns"}, o.organising);
}

struct PolarOptions {
  PolarMode mode = PolarMode::full;
  PolarMapOptions map;
  SonarMemoryOptions memory;
  PredictionOptions prediction;
  PolarSolverOptions solver;
  SubgoalReadoutOptions subgoal;
  MotionControlOptions control;
  TrapOptions trap;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"mode", "", "with the remedies beyond the paper, or without them: then their options are refused"},
        o.mode);
  visit(Field{"map", "", "the polar map"}, o.map);
  visit(Field{"memory", "", "the short-term memory"}, o.memory);
  visit(Field{"prediction", "", "prediction of the configuration"}, o.prediction);
  visit(Field{"solver", "", "how the equilibrium is found"}, o.solver);
  visit(Field{"subgoal", "", "how the subgoal is read off"}, o.subgoal);
  visit(Field{"control", "", "motion control"}, o.control);
  visit(Field{"trap", "", "trapped: when, and what then"}, o.trap);
}

/// Where something stands, in the odometry frame, as of this observation: called once a cycle, replaces the list.
using OwnObstacles = std::function<void(const Observation&, std::vector<Vec2>& points)>;

/// Parts of one's own; empty ones are the navigator's. `obstacles` takes the place of the remembered points in the map;
/// the escapes from traps go on with the memory.
struct PolarParts {
  OwnWeights weights;
  OwnObjective objective;
  OwnSubgoal subgoal;
  OwnObstacles obstacles;
};

/// The options with what the mode turns off turned off. Throws ArgumentError for what was given beside the mode and is
/// neither usual nor the mode's.
PolarOptions in_mode(PolarOptions options);

/// Throws ArgumentError at numbers out of range, and at those that contradict one another or the robot's size.
void check(const PolarOptions& options, const Body& body);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mapping/classic_options.hpp"
#include "robot/platform.hpp"

namespace meander {

/// One scan, as if all its readings had been taken from one pose: in ring order, the range from each transducer [m].
struct SonarSweep {
  std::span<const double> ranges;
  double range_max = 6.477;  ///< this and more: no echo [m]
};

/// Where cell centres are, seen from the robot; arrays of equal length, one element per cell.
struct CellPlaces {
  std::span<const float> range;    ///< from the robot's centre [m]
  std::span<const float> bearing;  ///< from the robot's heading, counter-clockwise; within two turns of 0 [rad]
  std::size_t size() const { return range.size(); }
};

/// What one scan tells about cells: the log-odds ln(P / (1 - P)) of each being occupied; 0: nothing. Whoever fuses
/// scans limits them and treats the robot's own disc. Models own their scratch memory: a call allocates nothing once it
/// has seen so many cells, and copies share it, so each thread makes a model of its own.
struct SonarModel {
  std::string name;
  RingLayout ring;   ///< the only one it can read
  double reach = 0;  ///< cells farther from the centre get 0 [m]
  std::function<void(const SonarSweep&, const CellPlaces&, std::span<float> log_odds)> evaluate;
  std::size_t bytes = 0;  ///< of weights, tables and scratch memory
};

/// What a model by name is made for.
struct SonarModelOptions {
  RingLayout ring;
  std::string preset = "ideal";  ///< sonar that the weights of a network were trained for
  bool table = false;            ///< networks: compiled to a lookup table, faster and a little worse
  ConeModelOptions elfes{};
  RangeLayerOptions ros{};
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarModelOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"preset", "", "networks: sonar that their weights were trained for"}, o.preset);
  visit(Field{"table", "", "networks: compiled to a lookup table, faster and a little worse"}, o.table);
  visit(Field{"elfes", "", "options of the model of this name"}, o.elfes);
  visit(Field{"ros", "", "options of the model of this name"}, o.ros);
}

/// Throws ArgumentError when the ring is none or has fewer sonars than `what` needs.
void check_sonars(const std::string& what, const RingLayout& ring, int least = 1);
/// Throws ArgumentError that tells the two apart when they are different rings.
void check_ring(const std::string& what, const RingLayout& made_for, const RingLayout& ring);

/// A new model; throws ArgumentError that lists the known names.
SonarModel sonar_model(const std::string& name, const SonarModelOptions& options = {});
std::vector<std::string> sonar_model_names();

}  // namespace meander

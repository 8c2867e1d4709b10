// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"

namespace meander {

/// How the equilibrium of a neural map is found.
enum class NeuralSolver { tiles, active_list, raster, synchronous };
template <>
struct EnumNames<NeuralSolver> {
  static constexpr std::pair<NeuralSolver, const char*> entries[] = {{NeuralSolver::tiles, "tiles"},
                                                                     {NeuralSolver::active_list, "active_list"},
                                                                     {NeuralSolver::raster, "raster"},
                                                                     {NeuralSolver::synchronous, "synchronous"}};
};

/// How much of the map is solved: all of it, or as much as the path from the start needs.
enum class NeuralExtent { map, start };
template <>
struct EnumNames<NeuralExtent> {
  static constexpr std::pair<NeuralExtent, const char*> entries[] = {{NeuralExtent::map, "map"},
                                                                     {NeuralExtent::start, "start"}};
};

/// f of the weights: 1 / rho or exp(-gamma rho^2), rho the cost of the step.
enum class WeightLaw { inverse, gaussian };
template <>
struct EnumNames<WeightLaw> {
  static constexpr std::pair<WeightLaw, const char*> entries[] = {{WeightLaw::inverse, "inverse"},
                                                                  {WeightLaw::gaussian, "gaussian"}};
};

struct NeuralMapOptions {
  NeuralSolver solver = NeuralSolver::tiles;
  NeuralExtent extent = NeuralExtent::map;
  int extra_patterns = 0;
  WeightLaw weights = WeightLaw::inverse;
  double gamma = 0.5;
  double steepness = 0.68;
  double tolerance = 1e-6;
  int threads = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, NeuralMapOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"solver", "", "how the equilibrium is found"}, o.solver);
  visit(Field{"extent", "", "solve the whole map, or what the path from the start needs"}, o.extent);
  visit(Field{"extra_patterns", "",
              "raster and synchronous with extent start: so many patterns more than the front needs", 0, 1000},
        o.extra_patterns);
  visit(Field{"weights", "", "weight of a connection of cost rho: 1 / rho or exp(-gamma rho^2)"}, o.weights);
  visit(Field{"gamma", "", "of gaussian weights", 0, 10}, o.gamma);
  visit(Field{"steepness", "", "beta times the largest sum of a unit's weights; 0.68 is the paper's beta of 0.1", 0.35,
              0.9},
        o.steepness);
  visit(Field{"tolerance", "", "largest relative error of a unit's equation at the end", 1e-12, 1e-2}, o.tolerance);
  visit(Field{"threads", "", "of the tiles solver; 0: all cores; the same landscape with any number", 0, 256},
        o.threads);
}

}  // namespace meander

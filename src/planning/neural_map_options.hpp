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

struct NeuralMapOptions {
  NeuralSolver solver = NeuralSolver::active_list;
  double steepness = 0.68;
  double tolerance = 1e-6;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, NeuralMapOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"solver", "", "how the equilibrium is found"}, o.solver);
  visit(Field{"steepness", "", "beta times the largest sum of a unit's weights; 0.68 is the paper's beta of 0.1", 0.35,
              0.9},
        o.steepness);
  visit(Field{"tolerance", "", "largest relative error of a unit's equation at the end", 1e-12, 1e-2}, o.tolerance);
}

}  // namespace meander

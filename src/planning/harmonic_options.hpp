// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"

namespace meander {

/// exact: a sparse system, factored. sor: successive over-relaxation, as it was done.
enum class HarmonicSolver { exact, sor };
template <>
struct EnumNames<HarmonicSolver> {
  static constexpr std::pair<HarmonicSolver, const char*> entries[] = {{HarmonicSolver::exact, "exact"},
                                                                       {HarmonicSolver::sor, "sor"}};
};

struct HarmonicOptions {
  HarmonicSolver solver = HarmonicSolver::exact;
  double tolerance = 1e-6;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, HarmonicOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"solver", "", "how the harmonic function is found"}, o.solver);
  visit(Field{"tolerance", "", "largest relative change of a cell in a sweep at the end (sor)", 1e-12, 1e-2},
        o.tolerance);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The equilibrium of a neural map once more, as different from src/planning as can be: numbers of 40 decimal digits and
// an exponent without end, links asked cell by cell, sweeps up and down in the order of a breadth-first search, no
// over-relaxation, library tanh. It shares only the lattice and the problem.
#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "planning/problem.hpp"

namespace meander::neural_reference {

namespace mp = boost::multiprecision;
using Wide =
    mp::number<mp::cpp_bin_float<40, mp::digit_base_10, void, std::int64_t, -100000000, 100000000>, mp::et_off>;

struct Unit {
  Cell cell;
  std::vector<std::pair<std::size_t, double>> inputs;  ///< unit and w
};

inline std::vector<Unit> units_by_distance(const PlanningProblem& problem, Grid<int>& number) {
  std::vector<Unit> units;
  const auto add = [&](Cell cell) {
    if (number[cell] >= 0) return;
    number[cell] = static_cast<int>(units.size());
    units.push_back({cell, {}});
  };
  for (const Cell target : problem.targets) add(target);
  for (std::size_t i = 0; i < units.size(); ++i) {
    const Cell cell = units[i].cell;
    for (const LatticeStep& step : lattice_steps(problem.lattice, cell.y))
      if (open_step(problem.blocked, problem.corners, cell, step)) add({cell.x + step.dx, cell.y + step.dy});
  }
  for (Unit& unit : units)
    for (const LatticeStep& step : lattice_steps(problem.lattice, unit.cell.y))
      if (open_step(problem.blocked, problem.corners, unit.cell, step))
        unit.inputs.emplace_back(number[{unit.cell.x + step.dx, unit.cell.y + step.dy}],
                                 1 / step_cost(problem, unit.cell, step));
  return units;
}

/// v of every cell, 0 where there is none.
inline Grid<Wide> equilibrium(const PlanningProblem& problem, double beta) {
  Grid<int> number(problem.blocked.width(), problem.blocked.height(), -1);
  const std::vector<Unit> units = units_by_distance(problem, number);
  std::vector<Wide> v(units.size(), Wide(0));
  for (std::size_t i = 0; i < problem.targets.size(); ++i) v[i] = 1;
  const Wide linear("1e-12"), done("1e-15"), slope(beta);
  bool changed = true;
  const auto update = [&](std::size_t i) {
    Wide sum(0);
    for (const auto& [j, w] : units[i].inputs) sum += Wide(w) * v[j];
    sum *= slope;
    if (sum > linear) sum = mp::tanh(sum);
    changed = changed || mp::abs(sum - v[i]) > done * sum;
    v[i] = sum;
  };
  while (changed) {
    changed = false;
    for (std::size_t i = problem.targets.size(); i < units.size(); ++i) update(i);
    for (std::size_t i = units.size(); i-- > problem.targets.size();) update(i);
  }
  Grid<Wide> field(problem.blocked.width(), problem.blocked.height(), Wide(0));
  for (std::size_t i = 0; i < units.size(); ++i) field[units[i].cell] = v[i];
  return field;
}

}  // namespace meander::neural_reference

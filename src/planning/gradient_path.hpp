// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/path.hpp"

namespace meander {

/// [LM99+] "interpolation methods to smooth out the activation landscape" are named, not told. Ours: the gradient of
/// the landscape at the cells' centres, interpolated between them, followed in steps of a quarter of a cell. A step
/// that the robot's body cannot take, or that leads nowhere, is one to the best neighbour's centre instead.
PlannedPath gradient_path(const PlanningProblem& problem, const PlanningResult& result, const Clearance& clearance,
                          const Work& work = {});

/// Gradient of the landscape at a cell's centre; components that lead into a wall are 0.
Vec2 gradient_at(const PlanningProblem& problem, const Grid<double>& value, Cell cell);

}  // namespace meander

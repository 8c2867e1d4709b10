// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/landscape.hpp"

namespace meander {

/// A short way in straight pieces between cells that see each other, at any angle: Theta*. Nearly the shortest there
/// is, so the measure of the others' lengths. Throws ArgumentError where costs are not lengths on a rectangular
/// lattice.
PlanningResult theta_star(const PlanningProblem& problem, const Work& work = {});

/// Does the straight line between the cells' centres pass only free cells? With Corners::keep it may not pass the
/// corner of a blocked cell either.
bool line_of_sight(const Grid<std::uint8_t>& blocked, Corners corners, Cell from, Cell to);

}  // namespace meander

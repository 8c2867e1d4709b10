// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "indicator/geodesic_field.hpp"

namespace meander {

/// The cells of a shortest way from a cell down to where the field began, both ends included; empty when none leads
/// there.
std::vector<Cell> way_down(const GeodesicField& field, Cell from);

/// The cell that the field reaches nearest to a place, within so many metres.
std::optional<Cell> nearest_reached(const ConfigurationSpace& space, const GeodesicField& field, const Vec2& at,
                                    double within);

/// The nearest free cell to a place, within so many metres.
std::optional<Cell> nearest_free(const ConfigurationSpace& space, const Vec2& at, double within);

/// The nearest cell where nothing speaks against the robot's being, within so many metres.
std::optional<Cell> nearest_open(const ConfigurationSpace& space, const Vec2& at, double within);

/// The cells in which a robot is at a place: the place's own, or, where that is not free (with `unknown`: is blocked),
/// all that are (are not) and in which it is within so many metres wherever in them it stands.
std::vector<Cell> cells_at(const ConfigurationSpace& space, const Vec2& at, double within, bool unknown);

/// Nothing that is known stands on the straight way between two cells.
bool straight_way(const ConfigurationSpace& space, Cell from, Cell to);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace meander {

// What people do to worlds, in terms of edits. Each call is one undo step, all or nothing: when one of the things may
// not go there, none goes. Things given together may pass through each other.

/// Things whose whole name fits the pattern, in slot order: `*` stands for any run of characters, `?` for one.
std::vector<Id> matching(const World& world, const std::string& pattern);

/// Shifts by `by` [m]; movers take their waypoints along.
void move(World& world, const std::vector<Id>& ids, const Vec2& by);

/// Turns counter-clockwise by `by` [rad] about a point; by default about the centre of the box around all of them.
/// Headings of places turn too.
void turn(World& world, const std::vector<Id>& ids, double by, std::optional<Vec2> about = {});

/// Scales positions and sizes by `factor` > 0 about a point; by default about the centre of the box around all of them.
/// Tolerances of places stay.
void scale(World& world, const std::vector<Id>& ids, double factor, std::optional<Vec2> about = {});

/// Moves every point of walls and polygons, and the centre or position of everything else, to the nearest crossing of a
/// grid with lines every `step` metres. Refused when a shape would become invalid.
void snap(World& world, const std::vector<Id>& ids, double step);

void rename(World& world, Id id, const std::string& name);

/// Opens or closes a door; throws ArgumentError when the thing is no door.
void set_open(World& world, Id door, bool open);

/// Centre of the box around the things.
Vec2 center_of(const World& world, const std::vector<Id>& ids);

}  // namespace meander

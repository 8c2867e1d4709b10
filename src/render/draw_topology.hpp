// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "render/draw_list.hpp"
#include "render/theme.hpp"
#include "topology/topologic_map.hpp"

namespace meander {

/// Adds a topologic map to a picture: links darker the more confident, suspended ones in the colour of contacts,
/// places, the winner larger, and where the robot believes to be. The map lies in the frame that the picture is in.
void draw_topology(DrawList& list, const topology::TopologicMap& map, const Theme& theme);

/// The map alone, on a floor as large as it is.
DrawList draw_topology(const topology::TopologicMap& map);

}  // namespace meander

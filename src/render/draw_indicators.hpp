// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "indicator/indicator_graph.hpp"
#include "render/draw_list.hpp"
#include "render/theme.hpp"

namespace meander {

/// Adds a graph of indicators to the picture of its world: links (those by sight that two others do not lead along as
/// well), indicators with their serial numbers, and a stub in each direction that is unknown, blocked or a dead end.
void draw_indicators(DrawList& list, const IndicatorGraph& graph, const Theme& theme);

/// The graph alone, on a floor as large as it is.
DrawList draw_indicators(const IndicatorGraph& graph);

}  // namespace meander

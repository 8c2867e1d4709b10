// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/text_lines.hpp"
#include "indicator/indicator_graph.hpp"

namespace meander {

/// The lines of a graph, without the first one.
std::string graph_lines(const IndicatorGraph& graph);
/// Reads them, from the next line to the end of the text.
IndicatorGraph read_graph_lines(TextLines& lines);

}  // namespace meander

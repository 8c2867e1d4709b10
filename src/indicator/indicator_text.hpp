// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/text_lines.hpp"
#include "indicator/explorer.hpp"

namespace meander {

/// The graph as text, a line per indicator, port and link, always in the same order:
///
///   meander indicators 1
///   indicator 1 1 0.5 0.5                    serial number, generation, x, y [m]
///   port 1.5707963267948966 2.5 linked 0 2 0 0 0 0   direction [rad], reach [m], state, tries, passed, failures,
///                                                  closed_run, misses, bound [m]
///   free 2 1                                 serial number, generation: removed
///   link 1.1 3.2 4                           two ends (indicator.port, or the indicator alone), length [m]
///   end                                      else the file was cut off
std::string to_text(const IndicatorGraph& graph);
/// Throws FileError "path:line: what is wrong".
IndicatorGraph graph_from_text(const std::string& text, const std::string& path = "text");

/// An explorer in the middle of its work: goal, options, where it is, and its graph. Reading it gives an explorer that
/// decides on like the one that was written.
std::string to_text(const Explorer& explorer);
Explorer explorer_from_text(const std::string& text, const std::string& path = "text");

/// Parts of such texts, for others that hold an explorer: the first line, the goal, the state and the graph up to the
/// end.
void check_header(TextLines& lines, const char* what);
std::string goal_line(const Vec2& goal);
Vec2 read_goal_line(TextLines& lines);
std::string state_lines(const Explorer& explorer);
void read_state_lines(TextLines& lines, Explorer& explorer);

void write_graph(const IndicatorGraph& graph, const std::string& path);
IndicatorGraph read_graph(const std::string& path);
void write_explorer(const Explorer& explorer, const std::string& path);
Explorer read_explorer(const std::string& path);

}  // namespace meander

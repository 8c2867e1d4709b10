// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/text_lines.hpp"
#include "indicator/sonar_occupancy.hpp"

namespace meander {

/// What a sonar map remembers as lines: its room, then runs of cells of which something is known.
///
///   map 57 1.5 0.5 0.12 -8 -8 9.5 9.5     scans, last x, y, heading, room low x, y, high x, y
///   cells 12 40 -3 -4.5 1                  column and row of the first, evidence cell by cell to the right
std::string occupancy_lines(const SonarOccupancy& map);
/// Reads them, up to a line "done". The map has the options of that which was written.
void read_occupancy_lines(TextLines& lines, SonarOccupancy& map);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/occupancy_text.hpp"

#include <iterator>

namespace meander {
namespace {

constexpr double kFarthest = 1e6;  ///< [m]
constexpr int kRun = 64;           ///< cells in a line

Vec2 place(const TextLines& lines, std::size_t word) {
  const Vec2 at{lines.number(word), lines.number(word + 1)};
  if (at.cwiseAbs().maxCoeff() > kFarthest) lines.wrong("a place within {:g} m expected", kFarthest);
  return at;
}

void read_cells(const TextLines& lines, Grid<float>& evidence) {
  if (lines.words().size() < 4) lines.wrong("'cells X Y EVIDENCE...' expected");
  const Cell first{lines.integer(1, 0, evidence.width() - 1), lines.integer(2, 0, evidence.height() - 1)};
  for (std::size_t word = 3; word < lines.words().size(); ++word) {
    const Cell cell{first.x + static_cast<int>(word) - 3, first.y};
    if (!evidence.contains(cell)) lines.wrong("{} cells from column {} on are too many", word - 2, first.x);
    evidence[cell] = static_cast<float>(lines.number(word));
  }
}

}  // namespace

std::string occupancy_lines(const SonarOccupancy& map) {
  const SonarOccupancy::Memory m = map.memory();
  std::string text = fmt::format("map {} {} {} {} {} {} {} {}\n", m.scans, m.last.x(), m.last.y(), m.last_heading,
                                 m.low.x(), m.low.y(), m.high.x(), m.high.y());
  const auto out = std::back_inserter(text);
  for (int y = 0; y < m.evidence.height(); ++y)
    for (int x = 0; x < m.evidence.width(); ++x) {
      if (m.evidence[{x, y}] == 0) continue;
      fmt::format_to(out, "cells {} {}", x, y);
      for (const int end = x + kRun; x < end && m.evidence.at({x, y}, 0) != 0; ++x)
        fmt::format_to(out, " {}", m.evidence[{x, y}]);
      text += '\n';
      --x;
    }
  return text + "done\n";
}

void read_occupancy_lines(TextLines& lines, SonarOccupancy& map) {
  if (!lines.next() || !lines.is("map")) lines.wrong("'map' expected");
  lines.count(9, "map SCANS X Y HEADING LOW_X LOW_Y HIGH_X HIGH_Y");
  SonarOccupancy::Memory memory;
  memory.scans = lines.integer(1, 0, 1 << 30);
  memory.last = place(lines, 2);
  memory.last_heading = lines.number(4);
  memory.low = place(lines, 5);
  memory.high = place(lines, 7);
  const Vec2 room = (memory.high - memory.low) / map.space().resolution();
  if (!(room.minCoeff() >= 0) || !((room.x() + 1) * (room.y() + 1) <= SonarOccupancy::kMostCells))
    lines.wrong("a room of 1 to {:g} cells expected", SonarOccupancy::kMostCells);
  memory.evidence = map.empty_room(memory.low, memory.high);
  while (lines.next() && lines.is("cells")) read_cells(lines, memory.evidence);
  if (!lines.is("done")) lines.wrong("'cells' or 'done' expected");
  map.restore(memory);
}

}  // namespace meander

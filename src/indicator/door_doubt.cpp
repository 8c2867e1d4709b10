// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/door_doubt.hpp"

namespace meander {
namespace {

constexpr double kCertainlyFree = -10;  ///< evidence: what noise alone does not close again

}  // namespace

void DoorDoubt::begin(SonarOccupancy& map, int run, int recheck) {
  fit(map);
  const bool doubt = recheck > 0 && run % recheck == 0;
  for (int y = 0; y < once_.height(); ++y)
    for (int x = 0; x < once_.width(); ++x) {
      const Cell cell{x, y};
      if (map.evidence(cell) <= kCertainlyFree) once_[cell] = 1;
      if (doubt && once_[cell] != 0 && map.evidence(cell) > 0) map.forget(cell);
    }
}

/// The map may have grown.
void DoorDoubt::fit(const SonarOccupancy& map) {
  const ConfigurationSpace& space = map.space();
  if (once_.frame == space.frame() && once_.width() == space.width() && once_.height() == space.height()) return;
  const Grid<std::uint8_t> before = std::move(once_);
  once_ = Grid<std::uint8_t>(space.width(), space.height(), 0, space.frame());
  if (before.width() == 0) return;
  const Cell shift = once_.frame.cell(before.frame.center({0, 0}));
  for (int y = 0; y < before.height(); ++y)
    for (int x = 0; x < before.width(); ++x)
      if (before[{x, y}] != 0) once_[{x + shift.x, y + shift.y}] = 1;
}

std::string DoorDoubt::lines() const {
  std::string text;
  for (int y = 0; y < once_.height(); ++y)
    for (int x = 0; x < once_.width(); ++x) {
      const int first = x;
      while (once_.at({x, y}, 0) != 0) ++x;
      if (x > first) text += fmt::format("once {} {} {}\n", first, y, x - first);
    }
  return text + "done\n";
}

void DoorDoubt::read(TextLines& lines, const SonarOccupancy& map) {
  fit(map);
  while (lines.next() && lines.is("once")) {
    lines.count(4, "once X Y CELLS");
    const int x = lines.integer(1, 0, once_.width() - 1), y = lines.integer(2, 0, once_.height() - 1);
    const int cells = lines.integer(3, 1, once_.width() - x);
    for (int i = 0; i < cells; ++i) once_[{x + i, y}] = 1;
  }
  if (!lines.is("done")) lines.wrong("'once' or 'done' expected");
}

}  // namespace meander

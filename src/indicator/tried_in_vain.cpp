// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/tried_in_vain.hpp"

#include <algorithm>

namespace meander {
namespace {

constexpr double kSame = 0.5;  ///< stops nearer than this are stops at the same place [m]
constexpr double kOnce = 5;    ///< evidence for a wall where the robot did not get on: a weak one
constexpr double kAgain = 30;  ///< the same when it is stopped there again
constexpr int kHalfWidth = 2;  ///< of the wall, in cells

}  // namespace

void TriedInVain::stop(SonarOccupancy& map, const Vec2& at, const Vec2& ahead) {
  const Vec2 way = ahead - at;
  if (!(way.norm() > 1e-6)) return;
  const Vec2 along = way / way.norm(), across(-along.y(), along.x());
  const GridFrame& frame = map.space().frame();
  const bool again =
      std::any_of(stops_.begin(), stops_.end(), [&](const Vec2& stop) { return (stop - at).norm() < kSame; });
  stops_.push_back(at);
  for (int i = -kHalfWidth; i <= kHalfWidth; ++i) {
    const Cell cell = frame.cell(at + (map.reach() + frame.resolution) * along + i * frame.resolution * across);
    const double before = map.evidence(cell), drawn = again ? kAgain : kOnce;
    if (before >= drawn) continue;
    drawn_.push_back({frame.center(cell), before});
    map.raise(cell, drawn);
  }
}

bool TriedInVain::take_back(SonarOccupancy& map) {
  for (auto one = drawn_.rbegin(); one != drawn_.rend(); ++one) {  // a cell drawn twice: what was known first
    const Cell cell = map.space().frame().cell(one->place);
    const double now = map.evidence(cell);
    if (now > one->before) map.add(cell, one->before - now);
  }
  const bool any = !drawn_.empty();
  drawn_.clear();
  stops_.clear();
  return any;
}

std::string TriedInVain::lines() const {
  std::string text;
  for (const Drawn& one : drawn_) text += fmt::format("tried {} {} {}\n", one.place.x(), one.place.y(), one.before);
  return text + "done\n";
}

void TriedInVain::read(TextLines& lines) {
  while (lines.next() && lines.is("tried")) {
    lines.count(4, "tried X Y EVIDENCE");
    drawn_.push_back({{lines.number(1), lines.number(2)}, lines.number(3)});
  }
  if (!lines.is("done")) lines.wrong("'tried' or 'done' expected");
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/outline.hpp"

namespace meander {
namespace {

using Heading = Outline::Heading;

constexpr Cell kStep[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

/// From a corner to the cell that lies ahead and to the left of a walker with a heading.
constexpr Cell kAheadLeft[] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};

Cell sum(Cell a, Cell b) { return {a.x + b.x, a.y + b.y}; }

class Walker {
 public:
  explicit Walker(const Grid<std::uint8_t>& solid) : solid_(solid), seen_(solid.width(), solid.height(), 0) {}

  /// Does an outline that was not walked yet run east along the lower side of the cell?
  bool begins_at(Cell cell) const { return is_solid(cell) && !seen_[cell] && !is_solid({cell.x, cell.y - 1}); }

  Outline walk(Cell cell) {
    Outline outline;
    outline.inside = cell;
    int turns = 0;
    Outline::Step step{cell, Heading::east};
    do {
      if (step.heading == Heading::east) seen_[step.from] = 1;
      outline.steps.push_back(step);
      // Green's theorem, one unit step at a time.
      outline.area_cells += step.from.x * kStep[static_cast<int>(step.heading)].y;
      step = after(step);
      turns += step.turn;
    } while (!(step.from == cell && step.heading == Heading::east));
    outline.steps.front() = step;  // only now is its turn known
    outline.hole = turns < 0;
    return outline;
  }

 private:
  bool is_solid(Cell cell) const { return solid_.at(cell, 0) != 0; }

  /// Asking to the right first joins solid cells across a corner.
  Outline::Step after(const Outline::Step& step) const {
    const int heading = static_cast<int>(step.heading);
    const Cell corner = sum(step.from, kStep[heading]);
    const bool left = is_solid(sum(corner, kAheadLeft[heading]));
    const bool right = is_solid(sum(corner, kAheadLeft[(heading + 3) % 4]));
    const int turn = right ? -1 : left ? 0 : 1;
    return {corner, static_cast<Heading>((heading + turn + 4) % 4), turn, right && !left};
  }

  const Grid<std::uint8_t>& solid_;
  Grid<std::uint8_t> seen_;
};

}  // namespace

void walk_outlines(const Grid<std::uint8_t>& solid, const Work& work, const std::function<void(const Outline&)>& take) {
  Walker walker(solid);
  for (int y = 0; y < solid.height(); ++y) {
    work.poll();
    for (int x = 0; x < solid.width(); ++x)
      if (walker.begins_at({x, y})) take(walker.walk({x, y}));
  }
}

}  // namespace meander

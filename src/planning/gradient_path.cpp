// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/gradient_path.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

constexpr double kStride = 0.25;     // [cells]
constexpr int kPatience = 24;        // strides that may lead to no better cell
constexpr double kTolerance = 1e-9;  // of clearances [cells]

class GradientAscent {
 public:
  GradientAscent(const PlanningProblem& problem, const PlanningResult& result, const Clearance& clearance)
      : problem_(problem), result_(result), clearance_(clearance), at_(cell_center(problem.lattice, *problem.start)) {
    path_.points.push_back(at_);
    best_ = result.value[*problem.start];
  }

  PlannedPath climb(const Work& work) {
    while (!arrived()) {
      if (path_.points.size() % 1024 == 0) work.poll();
      if (stalled_ < kPatience && stride()) continue;
      if (!fall_back()) return {.points = {}, .reason = "the landscape has a local maximum that is no target"};
    }
    return std::move(path_);
  }

 private:
  Cell cell() const { return cell_at(problem_.lattice, at_); }
  void go(const Vec2& to) {
    if (to == at_) return;
    at_ = to;
    path_.points.push_back(to);
  }
  bool clear(const Vec2& to) const {
    return clearance_.of(at_, to, problem_.robot_radius) >= problem_.robot_radius - kTolerance;
  }

  /// In a target's cell, or straight before one: on to its centre.
  bool arrived() {
    for (const Cell target : problem_.targets) {
      const Vec2 goal = cell_center(problem_.lattice, target);
      if (problem_.blocked.at(target, 1) != 0 || (goal - at_).norm() > 1 || !clear(goal)) continue;
      go(goal);
      return true;
    }
    return false;
  }

  bool stride() {
    const Vec2 slope = interpolated();
    const double steepness = slope.norm();
    if (!(steepness > 0)) return false;
    const Vec2 to = at_ + slope * (kStride / steepness);
    const double value = result_.value.at(cell_at(problem_.lattice, to), kNoValue);
    if (value == kNoValue || !clear(to)) return false;
    go(to);
    stalled_ = value > best_ ? 0 : stalled_ + 1;
    best_ = std::max(best_, value);
    return true;
  }

  /// By the centre of the own cell, which can always be reached from within it, to cells that are better than all
  /// before.
  bool fall_back() {
    go(cell_center(problem_.lattice, cell()));
    do {
      const std::optional<Cell> next = best_neighbour(problem_, result_, PathKind::steepest, cell());
      if (!next) return false;
      go(cell_center(problem_.lattice, *next));
      ++path_.fallbacks;
    } while (!(result_.value[cell()] > best_));
    best_ = result_.value[cell()];
    stalled_ = 0;
    return true;
  }

  /// How much a cell counts at a distance from its centre: bilinear, or a cone on hexagons.
  double weight(const Vec2& away) const {
    if (problem_.lattice == Lattice::hexagonal) return std::max(1 - away.norm(), 0.0);
    return std::max(1 - std::abs(away.x()), 0.0) * std::max(1 - std::abs(away.y()), 0.0);
  }

  Vec2 interpolated() const {
    const Cell here = cell();
    Vec2 sum(0, 0);
    double all = 0;
    const auto add = [&](Cell c) {
      const double w = weight(cell_center(problem_.lattice, c) - at_);
      if (w <= 0 || result_.value.at(c, kNoValue) == kNoValue) return;
      sum += w * gradient_at(problem_, result_.value, c);
      all += w;
    };
    add(here);
    const std::span<const LatticeStep> steps = lattice_steps(problem_.lattice, here.y);
    for (const LatticeStep& step : steps.first(std::min<std::size_t>(steps.size(), 8)))
      if (open_step(problem_.blocked, problem_.corners, here, step)) add({here.x + step.dx, here.y + step.dy});
    return all > 0 ? Vec2(sum / all) : sum;
  }

  const PlanningProblem& problem_;
  const PlanningResult& result_;
  const Clearance& clearance_;
  PlannedPath path_;
  Vec2 at_;
  double best_;      ///< highest value of a cell so far
  int stalled_ = 0;  ///< strides since then
};

}  // namespace

Vec2 gradient_at(const PlanningProblem& problem, const Grid<double>& value, Cell cell) {
  // Least squares over the nearest neighbours: sum of u u^T is 2 I for 4 unit vectors, 3 I for 6.
  const std::span<const LatticeStep> steps = lattice_steps(problem.lattice, cell.y);
  const bool hexagonal = problem.lattice == Lattice::hexagonal;
  const Vec2 center = cell_center(problem.lattice, cell);
  Vec2 gradient(0, 0);
  for (std::size_t k = 0; k < (hexagonal ? 6 : 4); k += 2) {
    double rise[2];
    for (std::size_t i = 0; i < 2; ++i)
      rise[i] = value.at({cell.x + steps[k + i].dx, cell.y + steps[k + i].dy}, kNoValue) - value[cell];
    const Vec2 ahead = cell_center(problem.lattice, {cell.x + steps[k].dx, cell.y + steps[k].dy}) - center;
    const bool forth = rise[0] != kNoValue, back = rise[1] != kNoValue;
    // With one side only: what it says, unless that leads into the other.
    const double slope = forth && back ? (rise[0] - rise[1]) / 2
                         : forth       ? std::max(rise[0], 0.0)
                         : back        ? -std::max(rise[1], 0.0)
                                       : 0;
    gradient += slope * ahead;
  }
  return gradient;
}

PlannedPath gradient_path(const PlanningProblem& problem, const PlanningResult& result, const Clearance& clearance,
                          const Work& work) {
  return GradientAscent(problem, result, clearance).climb(work);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/map_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/area_under_curve.hpp"
#include "world/rasterize.hpp"

namespace meander {
namespace {

constexpr double kStride = 0.01;    ///< along a direction [m]
constexpr double kSurest = 0.0001;  ///< probabilities are kept so far from 0 and 1 in the cross-entropy
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Scored {
  double probability;
  bool occupied;
};

std::vector<Scored> seen_cells(const Grid<float>& probability, const Grid<CellTruth>& truth, MapScore& score) {
  std::vector<Scored> cells;
  for (std::size_t i = 0; i < truth.cells().size(); ++i) {
    if (truth.cells()[i] == CellTruth::hidden) continue;
    const bool occupied = truth.cells()[i] == CellTruth::occupied;
    cells.push_back({std::clamp<double>(probability.cells()[i], 0, 1), occupied});
    ++(occupied ? score.occupied : score.free);
  }
  return cells;
}

/// Of each cell, so that both classes together weigh 1.
double weight_of(const Scored& cell, const MapScore& score) {
  return 0.5 / (cell.occupied ? score.occupied : score.free);
}

void score_probabilities(const std::vector<Scored>& cells, MapScore& score) {
  const auto bins = static_cast<double>(score.reliability.size());
  for (const Scored& cell : cells) {
    const double w = weight_of(cell, score), p = cell.probability, right = cell.occupied ? p : 1 - p;
    score.ce -= w * std::log(std::clamp(right, kSurest, 1.0));
    score.brier += w * (1 - right) * (1 - right);
    ReliabilityBin& bin = score.reliability[static_cast<std::size_t>(std::min(p * bins, bins - 1))];
    bin.weight += w;
    bin.predicted += w * p;
    bin.occupied += cell.occupied ? w : 0;
  }
  for (const ReliabilityBin& bin : score.reliability) score.ece += std::abs(bin.predicted - bin.occupied);
}

/// The statistic of Mann and Whitney; ties count half.
/// Distance to the first cell for which `blocked` holds; none: how far the grid reaches that way.
template <class Blocked>
std::pair<double, bool> first_blocked(const Grid<float>& grid, const Vec2& from, const Vec2& way, double begin,
                                      Blocked blocked) {
  double distance = begin;
  for (;; distance += kStride) {
    const Cell cell = grid.frame.cell(from + distance * way);
    if (!grid.contains(cell)) return {distance, false};
    if (blocked(cell)) return {distance, true};
  }
}

/// [CN] Figure 6.
void score_directions(const Grid<float>& probability, const Sim& sim, std::size_t robot, const MapScoreOptions& options,
                      MapScore& score) {
  const int directions = options.directions;
  const auto threshold = static_cast<float>(options.threshold);
  const Vec2 low = probability.frame.origin.position(), from = sim.state(robot).pose_world.position();
  const double side = probability.frame.resolution, begin = sim.robot(robot).platform.sonar.radius;
  const Vec2 size = side * Vec2(probability.width() - 0.5, probability.height() - 0.5);
  const Grid<std::uint8_t> solid = rasterize(sim.world(), side, {low, low + size});
  int with = 0, missed = 0, phantoms = 0;
  for (int i = 0; i < directions; ++i) {
    const SinCos t = sin_cos(2 * kPi * i / directions);
    const Vec2 way(t.cos, t.sin);
    const auto [mapped, shown] =
        first_blocked(probability, from, way, begin, [&](Cell c) { return probability[c] > threshold; });
    const auto [true_distance, is_there] =
        first_blocked(probability, from, way, begin, [&](Cell c) { return solid.at(c, 0) != 0; });
    score.error += std::abs(mapped - true_distance) / directions;
    with += is_there;
    missed += is_there && !shown;
    phantoms += shown && !is_there;
  }
  score.missed = with ? static_cast<double>(missed) / with : 0;
  score.phantom = with < directions ? static_cast<double>(phantoms) / (directions - with) : 0;
}

}  // namespace

MapScore score_map(const Grid<float>& probability, const Sim& sim, std::size_t robot, const MapScoreOptions& options) {
  validate(options);
  const Grid<CellTruth> truth =
      map_truth(sim, robot, probability.width(), probability.height(), probability.frame, options.truth);
  MapScore score;
  score.reliability.resize(static_cast<std::size_t>(options.bins));
  const std::vector<Scored> cells = seen_cells(probability, truth, score);
  if (score.free && score.occupied) {
    score_probabilities(cells, score);
    std::vector<std::pair<double, bool>> scored;
    for (const Scored& cell : cells) scored.emplace_back(cell.probability, cell.occupied);
    score.auc = area_under_curve(std::move(scored));
  } else {
    score.ce = score.brier = score.auc = score.ece = kUnknown;
  }
  if (!probability.cells().empty()) score_directions(probability, sim, robot, options, score);
  return score;
}

}  // namespace meander

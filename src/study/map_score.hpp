// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "study/map_truth.hpp"

namespace meander {

struct MapScoreOptions {
  MapTruthOptions truth;
  int directions = 72;
  double threshold = 0.5;
  int bins = 10;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapScoreOptions>
void fields(Options& o, Visitor&& visit) {
  fields(o.truth, visit);
  visit(Field{"directions", "", "in which the distance to the first obstacle is compared", 1, 10000}, o.directions);
  visit(Field{"threshold", "", "probability above which a cell is an obstacle in these directions", 0.01, 0.99},
        o.threshold);
  visit(Field{"bins", "", "of the reliability curve", 1, 1000}, o.bins);
}

/// Cells to which a map gives about the same probability. Sums, so that the bins of several maps can be added.
struct ReliabilityBin {
  double weight = 0;     ///< of the cells
  double predicted = 0;  ///< sum of their probabilities, weighted
  double occupied = 0;   ///< weight of the occupied ones
};

/// How good a map is on the cells that are seen. Both classes weigh the same, whatever their numbers: that fits the
/// prior 0.5 of [CN] eq. (5). nan where a class has no cell.
struct MapScore {
  int free = 0, occupied = 0;  ///< cells
  double ce = 0;               ///< mean cross-entropy [nat]; 0.693: a coin
  double brier = 0;            ///< mean squared error of the probability
  double auc = 0;              ///< share of pairs of an occupied and a free cell in right order
  double ece = 0;              ///< expected calibration error: mean |predicted - occupied| over the bins
  double error = 0;    ///< mean |distance to the first cell above the threshold - true distance| by direction [m]
  double missed = 0;   ///< share of the directions with an obstacle in the window where the map shows none
  double phantom = 0;  ///< share of the directions without one where the map shows one
  std::vector<ReliabilityBin> reliability;
};

/// Of a map of probabilities in the frame of the world, by the robot's view now. Throws ArgumentError.
MapScore score_map(const Grid<float>& probability, const Sim& sim, std::size_t robot,
                   const MapScoreOptions& options = {});

}  // namespace meander

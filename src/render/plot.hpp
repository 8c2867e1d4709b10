// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "render/draw_list.hpp"

namespace meander {

struct PlotWords {
  std::string title;
  std::string x, y;  ///< what the axes show, with the unit
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlotWords>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"title", "", "stands above the picture"}, o.title);
  visit(Field{"x", "", "what the x axis shows, with its unit"}, o.x);
  visit(Field{"y", "", "what the y axis shows, with its unit"}, o.y);
}

// To all of them a number beyond 1e300 is as one that is not finite.

/// Numbers over their index, 1 first, e.g. a training curve. Numbers that are not finite are gaps. Throws ArgumentError
/// when no number is finite.
DrawList draw_curve(std::span<const double> values, const PlotWords& words = {});

/// How often numbers fall into equal intervals; `bins` 0: as many as the square root of their count. Numbers that are
/// not finite are left out.
DrawList draw_histogram(std::span<const double> values, int bins = 0, const PlotWords& words = {});

/// A matrix, row by row, the first row on top: light is little, dark is much. Numbers that are not finite stay blank.
DrawList draw_heat_map(std::span<const float> values, int rows, int columns, const PlotWords& words = {});

/// Round numbers within [low, high], between two and a dozen; low < high.
std::vector<double> round_ticks(double low, double high);

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/hopfield_path.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace meander {
namespace {

/// A layer: k rows of n neurons, the first row fixed to the start and the last to the goal ([DG] Figure 6).
class Layer {
 public:
  Layer(const RouteLinks& links, int rows, int start, int goal, const HopfieldOptions& options)
      : links_(links), options_(options), rows_(rows), columns_(links.size()) {
    for (int column = 0; column < columns_; ++column)
      for (const RouteLinks::Way& way : links.ways(column)) longest_ = std::max(longest_, way.length);
    const auto neurons = static_cast<std::size_t>(rows_ * columns_);
    potential_.assign(neurons, 0);
    output_.assign(neurons, 0);
    column_sum_.assign(static_cast<std::size_t>(columns_), 0);
    Stream stream(options.seed, "hopfield");
    for (double& u : potential_) u = stream.uniform(-0.01, 0.01);
    output_[index(0, start)] = 1;
    output_[index(rows_ - 1, goal)] = 1;
  }

  void relax(const Work& work) {
    for (int step = 0; step < options_.steps; ++step) {
      work.poll();
      respond();
      for (int row = 1; row + 1 < rows_; ++row) drive(row);
    }
    respond();
  }

  /// The strongest neuron of each row, if they make a route.
  std::optional<Route> route() const {
    Route route;
    for (int row = 0; row < rows_; ++row) {
      const auto begin = output_.begin() + static_cast<std::ptrdiff_t>(index(row, 0));
      const int column = static_cast<int>(std::max_element(begin, begin + columns_) - begin);
      if (std::find(route.indicators.begin(), route.indicators.end(), column) != route.indicators.end()) return {};
      if (row > 0) {
        const double way = length(route.indicators.back(), column);
        if (way <= 0) return {};
        route.length += way;
      }
      route.indicators.push_back(column);
    }
    return route;
  }

 private:
  std::size_t index(int row, int column) const { return static_cast<std::size_t>(row * columns_ + column); }

  /// Of the shortest link between two indicators; 0: there is none.
  double length(int from, int to) const {
    double least = 0;
    for (const RouteLinks::Way& way : links_.ways(from))
      if (way.to == to && (least == 0 || way.length < least)) least = way.length;
    return least;
  }

  void respond() {
    std::fill(column_sum_.begin(), column_sum_.end(), 0.0);
    for (int row = 1; row + 1 < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const double x = 0.5 * options_.gain * potential_[index(row, column)];
        output_[index(row, column)] = 0.5 * (1 + x / std::sqrt(1 + x * x));  // a sigmoid with the same bits everywhere
      }
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        column_sum_[static_cast<std::size_t>(column)] += output_[index(row, column)];
  }

  void drive(int row) {
    double sum = 0, beside = 0;
    for (int column = 0; column < columns_; ++column) {
      sum += output_[index(row, column)];
      beside += output_[index(row - 1, column)] + output_[index(row + 1, column)];
    }
    for (int column = 0; column < columns_; ++column) {
      const double y = output_[index(row, column)];
      double cost = options_.missing * beside;  // of missing links, less what the links that exist make cheaper
      for (const RouteLinks::Way& way : links_.ways(column))
        cost -= (options_.missing - way.length / longest_) *
                (output_[index(row - 1, way.to)] + output_[index(row + 1, way.to)]);
      double& u = potential_[index(row, column)];
      u += options_.step *
           (-u - options_.row * (sum - y) - options_.column * (column_sum_[static_cast<std::size_t>(column)] - y) +
            options_.bias - options_.length * cost);
    }
  }

  const RouteLinks& links_;
  const HopfieldOptions& options_;
  int rows_, columns_;
  double longest_ = 1e-300;
  std::vector<double> potential_, output_, column_sum_;
};

}  // namespace

std::optional<Route> hopfield_path(const RouteLinks& links, int start, int goal, const HopfieldOptions& options,
                                   const Work& work) {
  validate(options);
  if (start < 0 || goal < 0 || start >= links.size() || goal >= links.size())
    fail("an indicator from 0 to {} expected, got {} and {}", links.size() - 1, start, goal);
  if (start == goal) return Route{.indicators = {start}, .length = 0};
  std::optional<Route> best;
  for (int rows = 2; rows <= PathNetwork::paper_rows(links.indicators()); ++rows) {  // [DG] eq. (1)
    Layer layer(links, rows, start, goal, options);
    layer.relax(work);
    const std::optional<Route> route = layer.route();
    if (route && (!best || route->length < best->length)) best = route;
  }
  return best;
}

}  // namespace meander

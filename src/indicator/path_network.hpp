// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/fields.hpp"
#include "base/work.hpp"
#include "indicator/route_links.hpp"

namespace meander {

/// How many rows the network has: as many as [DG] eq. (1) says, or as many as it takes to come to rest.
enum class NetworkRows { paper, adaptive };
template <>
struct EnumNames<NetworkRows> {
  static constexpr std::pair<NetworkRows, const char*> entries[] = {{NetworkRows::paper, "paper"},
                                                                    {NetworkRows::adaptive, "adaptive"}};
};

/// A route: indicators from start to goal, one per row.
struct Route {
  std::vector<int> indicators;  ///< empty: there is none
  double length = 0;            ///< [m]
};

/// The neural network that finds the shortest route, [DG] section 4, with rows that all layers share: row r of the
/// layer that forms routes of k indicators does not depend on k, so that one sheet of rows serves every layer.
///
/// [DG+] The paper says that each layer relaxes until one neuron is active in each row and column, without equations; a
/// plain relaxation of that kind finds valid routes only on small maps (hopfield_path.hpp). Here a neuron (row, column)
/// holds the least length of a route of so many indicators that ends at its indicator; neurons of a row compete for who
/// excites a neuron of the next row, and the winner is remembered.
class PathNetwork {
 public:
  /// A neuron that fired: excited in its row because its potential fell.
  struct Excited {
    int indicator = 0;     ///< its column
    int winner = -1;       ///< index in fired() of the neuron of the row before that excited it; -1 in the first row
    double potential = 0;  ///< length of the route up to here [m]
  };
  /// What one layer offers to the selecting layer.
  struct Candidate {
    int rows = 0;       ///< of the layer: indicators on the route
    int neuron = 0;     ///< index in fired() of the goal's neuron
    double length = 0;  ///< [m]
  };

  /// [DG] eq. (1): E = min(floor(2 sqrt n) + 1, n).
  static int paper_rows(int indicators);

  /// Spreads excitation from `start` row by row. With a goal, neurons that are farther than the goal is already keep
  /// still: they cannot lie on a shorter route. Throws ArgumentError for columns that are not there, Error where more
  /// than kMostFired neurons fire: with links much longer than their neighbours they can be the square of the columns.
  void excite(const RouteLinks& links, int start, std::optional<int> goal, NetworkRows rows, const Work& work = {});
  static constexpr std::size_t kMostFired = 5'000'000;

  /// The selecting layer: the least candidate, of equal ones that with fewer rows; none: no route within the rows.
  std::optional<Candidate> selected() const;
  const std::vector<Candidate>& candidates() const { return candidates_; }
  /// The route that a candidate stands for, from neuron to the winner that excited it.
  Route decrypt(const Candidate& candidate) const;
  /// The route to any column that excitation came to, after excite() without a goal; empty: none came.
  Route route_to(int column) const;

  /// The rows ended before the network came to rest: a shorter route, or any, may need more.
  bool truncated() const { return truncated_; }
  int rows() const { return static_cast<int>(first_.size()) - 1; }
  std::span<const Excited> row(int r) const;  ///< 0 first
  const std::vector<Excited>& fired() const { return fired_; }
  /// Least length to each column, infinite where no excitation came [m]. Without a goal these are the distances.
  const std::vector<double>& potentials() const { return potential_; }

 private:
  void reset(int columns);
  /// Makes the next row from the last one; false: nobody fired.
  bool fire(const RouteLinks& links, std::optional<int> goal);
  void forget_last_row();
  void offer(int goal);
  Route trace(int neuron, int rows) const;

  std::vector<Excited> fired_;
  std::vector<std::size_t> first_;  ///< of each row in fired_, and the end
  std::vector<double> potential_;
  std::vector<int> place_;  ///< of a column's last firing in fired_
  std::vector<Candidate> candidates_;
  bool truncated_ = false;
};

/// The shortest route by the network, or none.
std::optional<Route> neural_shortest_path(const RouteLinks& links, int start, int goal,
                                          NetworkRows rows = NetworkRows::adaptive);

}  // namespace meander

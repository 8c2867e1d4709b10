// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/path_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meander {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kLess = 1e-9;  ///< a potential fell when it is lower by more than that [m]

void check_column(const char* what, int column, int columns) {
  if (column < 0 || column >= columns)
    fail("{}: an indicator from 0 to {} expected, got {}", what, columns - 1, column);
}

}  // namespace

int PathNetwork::paper_rows(int indicators) {
  const auto twice = static_cast<int>(std::floor(2 * std::sqrt(static_cast<double>(std::max(indicators, 0)))));
  return std::min(twice + 1, indicators);
}

void PathNetwork::reset(int columns) {
  fired_.clear();
  first_.assign(1, 0);
  potential_.assign(static_cast<std::size_t>(columns), kInfinite);
  place_.assign(static_cast<std::size_t>(columns), -1);
  candidates_.clear();
  truncated_ = false;
}

void PathNetwork::excite(const RouteLinks& links, int start, std::optional<int> goal, NetworkRows rows,
                         const Work& work) {
  check_column("start", start, links.size());
  if (goal) check_column("goal", *goal, links.size());
  reset(links.size());
  const int most = rows == NetworkRows::paper ? paper_rows(links.indicators()) : std::numeric_limits<int>::max();
  // [DG] section 4: the first row of every layer is fixed to the start, the last one to the goal
  fired_.push_back({start, -1, 0});
  potential_[static_cast<std::size_t>(start)] = 0;
  place_[static_cast<std::size_t>(start)] = 0;
  first_.push_back(1);
  if (goal) offer(*goal);
  while (fire(links, goal)) {  // [DG+] a row in which nobody fires: at rest, the least potentials are exact
    if (this->rows() > most) {
      forget_last_row();
      truncated_ = true;
      return;
    }
    if (goal) offer(*goal);
    work.poll();
    if (fired_.size() > kMostFired)
      fail<Error>("network: it is not at rest after {} neurons fired in {} rows", fired_.size(), this->rows());
  }
}

bool PathNetwork::fire(const RouteLinks& links, std::optional<int> goal) {
  const std::size_t before = first_[first_.size() - 2], here = first_.back();
  const double bound = goal ? potential_[static_cast<std::size_t>(*goal)] : kInfinite;
  for (std::size_t i = before; i < here; ++i) {
    const Excited from = fired_[i];
    for (const RouteLinks::Way& way : links.ways(from.indicator)) {
      const double p = from.potential + way.length;
      const auto column = static_cast<std::size_t>(way.to);
      if (p >= bound) continue;
      if (place_[column] >= static_cast<int>(here)) {
        // Within the row the stronger excitation wins, of equal ones that of the lower serial number.
        Excited& rival = fired_[static_cast<std::size_t>(place_[column])];
        const bool lower = from.indicator < fired_[static_cast<std::size_t>(rival.winner)].indicator;
        if (p > rival.potential || (p == rival.potential && !lower)) continue;
        rival.winner = static_cast<int>(i);
        rival.potential = potential_[column] = p;
      } else if (p < potential_[column] - kLess) {
        place_[column] = static_cast<int>(fired_.size());
        potential_[column] = p;
        fired_.push_back({way.to, static_cast<int>(i), p});
      }
    }
  }
  if (fired_.size() == here) return false;
  first_.push_back(fired_.size());
  return true;
}

void PathNetwork::forget_last_row() {
  first_.pop_back();
  fired_.resize(first_.back());
  std::fill(potential_.begin(), potential_.end(), kInfinite);
  std::fill(place_.begin(), place_.end(), -1);
  for (std::size_t i = 0; i < fired_.size(); ++i) {
    potential_[static_cast<std::size_t>(fired_[i].indicator)] = fired_[i].potential;
    place_[static_cast<std::size_t>(fired_[i].indicator)] = static_cast<int>(i);
  }
}

/// The layer with as many rows as there are now has a candidate if the goal fired in its last row.
void PathNetwork::offer(int goal) {
  const int neuron = place_[static_cast<std::size_t>(goal)];
  if (neuron >= static_cast<int>(first_[first_.size() - 2]))
    candidates_.push_back({rows(), neuron, fired_[static_cast<std::size_t>(neuron)].potential});
}

std::optional<PathNetwork::Candidate> PathNetwork::selected() const {
  if (candidates_.empty()) return std::nullopt;
  return *std::min_element(candidates_.begin(), candidates_.end(),
                           [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
}

Route PathNetwork::decrypt(const Candidate& candidate) const { return trace(candidate.neuron, candidate.rows); }

Route PathNetwork::route_to(int column) const {
  check_column("column", column, static_cast<int>(place_.size()));
  const int neuron = place_[static_cast<std::size_t>(column)];
  if (neuron < 0) return {};
  int rows = 1;
  for (int i = neuron; (i = fired_[static_cast<std::size_t>(i)].winner) >= 0;) ++rows;
  return trace(neuron, rows);
}

/// One neuron per row, from the last row to the first.
Route PathNetwork::trace(int neuron, int rows) const {
  Route route{.indicators = std::vector<int>(static_cast<std::size_t>(rows)),
              .length = fired_[static_cast<std::size_t>(neuron)].potential};
  for (auto place = route.indicators.rbegin(); place != route.indicators.rend(); ++place) {
    const Excited& excited = fired_[static_cast<std::size_t>(neuron)];
    *place = excited.indicator;
    neuron = excited.winner;
  }
  return route;
}

std::span<const PathNetwork::Excited> PathNetwork::row(int r) const {
  if (r < 0 || r >= rows()) fail("row: a number from 0 to {} expected, got {}", rows() - 1, r);
  const auto i = static_cast<std::size_t>(r);
  return {fired_.data() + first_[i], fired_.data() + first_[i + 1]};
}

std::optional<Route> neural_shortest_path(const RouteLinks& links, int start, int goal, NetworkRows rows) {
  PathNetwork network;
  network.excite(links, start, goal, rows);
  const auto candidate = network.selected();
  return candidate ? std::optional(network.decrypt(*candidate)) : std::nullopt;
}

}  // namespace meander

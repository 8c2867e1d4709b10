// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/growing_net.hpp"

#include <algorithm>
#include <cmath>

namespace meander::topology {

GrowingNet::GrowingNet(const NetOptions& options, const SenseMetric& metric, double position_scale)
    : options_(options),
      metric_(metric),
      per_position_(position_scale > 0 ? 1 / (position_scale * position_scale) : 0),
      cells_(metric.stride()),
      // Lossless: a cell that is near enough in all is near enough in place.
      index_(position_scale > 0 ? options.insert_distance * position_scale : 1),
      rate_(options.adapt),
      neighbour_rate_(options.adapt_neighbours),
      middle_(static_cast<std::size_t>(metric.stride())) {}

Match GrowingNet::present(const Situation& situation, std::int64_t sample) {
  const auto match = nearest(situation);  // [Z] eq. (1)
  int winner;
  if (!match) {
    winner = insert(situation, sample, -1);  // "spontaneous insertion"
    miss();
  } else {
    winner = match->cell;
    adapt(*match, situation);  // [Z] eqs. (2), (3)
  }
  ++cells_[winner].hits;
  if (winner != winner_) change_winner(winner);  // [Z] eqs. (7), (8)
  if (options_.misses_to_insert > 0 && misses_ >= options_.misses_to_insert) insert_where_worst(sample);
  return {winner, match ? match->distance : 0};
}

double GrowingNet::squared(int cell, const Situation& situation, double limit) const {
  const double apart = per_position_ * (cells_[cell].position - situation.position).squaredNorm();
  if (apart > limit || metric_.stride() == 0) return apart;
  return apart + metric_.squared(cells_.senses(cell), situation.senses);
}

std::optional<Match> GrowingNet::nearest(const Situation& situation) const {
  double best = options_.insert_distance * options_.insert_distance;
  int winner = -1;
  const auto look = [&](int cell) {
    const double d = squared(cell, situation, best);
    if (d > best || (d == best && winner >= 0 && cell > winner)) return;
    best = d;
    winner = cell;
  };
  if (per_position_ > 0) {
    index_.around(situation.position, index_.side(), look);
  } else {
    for (int cell = 0; cell < cells_.slots(); ++cell)
      if (cells_[cell].alive()) look(cell);
  }
  if (winner < 0) return std::nullopt;
  return Match{winner, std::sqrt(best)};
}

int GrowingNet::insert(const Situation& situation, std::int64_t sample, int neighbour) {
  const int cell = cells_.add(situation.position, situation.senses, sample);
  if (per_position_ > 0) index_.add(cell, situation.position);
  errors_.set(cell, 0);
  if (neighbour >= 0) cells_.connect(cell, neighbour, {});
  return cell;
}

void GrowingNet::remove(int cell) {
  if (per_position_ > 0) index_.remove(cell);
  errors_.remove(cell);
  cells_.remove(cell);
  if (winner_ == cell) winner_ = -1;
}

void GrowingNet::pull(int cell, const Situation& situation, double share) {
  Cell& moved = cells_[cell];
  moved.position += share * (situation.position - moved.position);
  if (per_position_ > 0) index_.move(cell, moved.position);
  float* senses = cells_.senses(cell);
  const auto part = static_cast<float>(share);
  for (std::size_t k = 0; k < cells_.stride(); ++k) senses[k] += part * (situation.senses[k] - senses[k]);
}

void GrowingNet::adapt(const Match& match, const Situation& situation) {
  // [Z+] eqs. (2) and (3) subtract a scalar; the cells move towards the situation along the vector.
  pull(match.cell, situation, rate_);
  if (neighbour_rate_ > 0)
    for (const Link& link : cells_[match.cell].links) pull(link.to, situation, neighbour_rate_);
  errors_.set(match.cell, errors_.error(match.cell) + match.distance);  // [Z] eqs. (4), (5)
  if (match.distance <= options_.accept_distance) {                     // [Z] eq. (6)
    rate_ *= options_.settle;
    neighbour_rate_ = 0;
  } else {
    miss();
  }
}

void GrowingNet::miss() {
  rate_ = options_.adapt;
  neighbour_rate_ = options_.adapt_neighbours;
  ++misses_;
}

void GrowingNet::change_winner(int to) {
  if (winner_ >= 0) {
    cells_.connect(winner_, to, {});  // [Z] eq. (7); driven just now, so nothing speaks against it
    fade_links(to, winner_);
  }
  winner_ = to;
}

void GrowingNet::fade_links(int cell, int kept) {
  auto& links = cells_[cell].links;
  // Suspended links neither fade nor count: they may come back.
  const auto fading = [kept](const Link& link) { return link.to != kept && !link.suspended; };
  const auto m = std::count_if(links.begin(), links.end(), fading);
  const double loss = options_.fade / static_cast<double>(std::max<std::ptrdiff_t>(m, 1));  // [Z] eq. (8)
  for (std::size_t i = links.size(); i-- > 0;) {
    Link link = links[i];
    if (!fading(link)) continue;
    link.weight -= loss;
    if (link.weight > 0) {
      cells_.connect(cell, link.to, link);
    } else {
      cells_.disconnect(cell, link.to);
      drop_small_component(link.to, cell);
    }
  }
}

void GrowingNet::drop_small_component(int cell, int winner) {
  // [Z+] The paper removes unconnected clusters; only the smallest may go, or every bridge that fades takes half the
  // map.
  const auto least = static_cast<std::size_t>(options_.least_component);
  component_.assign(1, cell);
  for (std::size_t i = 0; i < component_.size() && component_.size() < least; ++i)
    for (const Link& link : cells_[component_[i]].links)
      if (std::find(component_.begin(), component_.end(), link.to) == component_.end()) component_.push_back(link.to);
  if (component_.size() >= least) return;
  if (std::find(component_.begin(), component_.end(), winner) != component_.end()) return;
  for (const int gone : component_) remove(gone);
}

void GrowingNet::insert_where_worst(std::int64_t sample) {
  misses_ = 0;
  const int runner = errors_.worst();
  const Cell& worst = cells_[runner];
  const Link* far = nullptr;
  double farthest = -1;
  for (const Link& link : worst.links) {
    const double d = squared(link.to, {worst.position, cells_.senses(runner)}, 1e300);
    if (d <= farthest) continue;
    farthest = d;
    far = &link;
  }
  if (!far) return;
  // "Statistical insertion" between the cell with the largest error and its farthest neighbour.
  const int other = far->to;
  const float *a = cells_.senses(runner), *b = cells_.senses(other);
  const auto touch =
      static_cast<std::size_t>(metric_.touch());  // a contact between two places is less sure than at them
  for (std::size_t k = 0; k < middle_.size(); ++k) middle_[k] = k < touch ? std::min(a[k], b[k]) : 0.5f * (a[k] + b[k]);
  const Vec2 between = 0.5 * (worst.position + cells_[other].position);
  errors_.set(runner, 0.5 * errors_.error(runner));
  const Link parted = *far;  // nobody drove the two that it becomes: what speaks against it speaks against them
  cells_.disconnect(runner, other);
  const int made = insert({between, middle_.data()}, sample, -1);
  for (const int end : {runner, other})
    cells_.connect(made, end, {.doubt = parted.doubt, .suspended = parted.suspended});
}

}  // namespace meander::topology

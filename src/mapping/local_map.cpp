// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/local_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mapping/cell_places.hpp"
#include "mapping/log_odds.hpp"

namespace meander {
namespace {

const LocalMapOptions& checked(const LocalMapOptions& options) {
  validate(options);
  return options;
}

constexpr double kFarthest = 1e9;  ///< cells from the origin: far below where integers end

int modulo(int value, int size) {
  const int rest = value % size;
  return rest < 0 ? rest + size : rest;
}

}  // namespace

LocalMap::LocalMap(const Platform& platform, SonarModel model, const LocalMapOptions& options, bool feeds)
    : options_(checked(options)),
      model_(std::move(model)),
      limit_(log_odds_of(options.fusion.certainty)),
      body_radius_(static_cast<float>(platform.body.radius)),
      sweeps_(platform.sonar, options.range_max),
      views_(options.fusion, options.fusion.rule == Fusion::viewbin ? options.size : 0, options.resolution, feeds),
      low_{-options.size / 2, -options.size / 2} {
  const std::string name = fmt::format("model \"{}\"", model_.name);
  check_sonars(name, platform.sonar);
  check_ring(name, model_.ring, platform.sonar);
  const auto cells = static_cast<std::size_t>(options_.size) * static_cast<std::size_t>(options_.size);
  for (auto* list : {&range_, &bearing_, &told_, &increments_, &cells_}) list->resize(cells);
  if (feeds) everywhere_.resize(cells);
}

/// One scan, as [CN] Figure 1 and section 3.1 list it.
void LocalMap::step(const Observation& observation) {
  const Pose2& pose = observation.odometry.pose;
  const Cell low = low_around(pose);  // what is refused leaves the map as it was
  views_.check_room();
  const SonarSweep sweep = sweeps_.sweep(observation.readings, pose);  // Figure 1: sensor readings
  place_cells(low, pose);                                              // Figure 3: R and theta of every cell
  model_.evaluate(sweep, {range_, bearing_}, told_);                   // sensors selector and network: P(c|o)
  slide(low);                                                          // 3.3 local maps
  weigh(pose.heading);                                                 // what of it is new
  update();                                                            // [CN] eq. (4)
}

Cell LocalMap::low_around(const Pose2& robot) const {
  const double reach = kFarthest * options_.resolution;
  if (!(std::abs(robot.x) < reach && std::abs(robot.y) < reach && std::isfinite(robot.heading)))
    fail("a pose within {} m of the origin expected, got ({}, {}, {})", reach, robot.x, robot.y, robot.heading);
  const Cell middle = cell(robot.position());
  return {middle.x - options_.size / 2, middle.y - options_.size / 2};
}

/// The robot's cell stays in the middle; cells that enter are unknown.
void LocalMap::slide(Cell to) {
  const int size = options_.size;
  const Cell from = std::exchange(low_, to);
  if (to == from) return;
  for (int y = to.y; y < to.y + size; ++y) {
    const bool new_row = y < from.y || y >= from.y + size;
    if (!new_row && to.x == from.x) continue;
    const int begin = new_row || to.x < from.x ? to.x : std::max(to.x, from.x + size);
    const int end = new_row || to.x > from.x ? to.x + size : std::min(to.x + size, from.x);
    for (int x = begin; x < end; ++x)
      replace({from.x + modulo(x - from.x, size), from.y + modulo(y - from.y, size)}, {x, y});
  }
}

/// Both lie at the same place of the ring buffer.
void LocalMap::replace(Cell left, Cell entered) {
  const std::size_t at = slot(entered);
  cells_[at] = 0;
  if (options_.fusion.rule == Fusion::viewbin) views_.replace(at, left, entered);
}

void LocalMap::clear() {
  std::fill(cells_.begin(), cells_.end(), 0.0F);
  views_.clear();
}

std::size_t LocalMap::slot(Cell cell) const {
  const int x = modulo(cell.x, options_.size), y = modulo(cell.y, options_.size);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(options_.size) + static_cast<std::size_t>(x);
}

void LocalMap::place_cells(Cell low, const Pose2& pose) {
  cell_places(center(low) - pose.position(), options_.resolution, options_.size, options_.size,
              wrap_angle(pose.heading), range_, bearing_);
}

/// Where the robot stands nothing else does.
void LocalMap::weigh(double heading) {
  const bool by_view = options_.fusion.rule == Fusion::viewbin, feeds = !everywhere_.empty();
  const auto turned = static_cast<float>(wrap_angle(heading));
  const auto size = static_cast<std::size_t>(options_.size);
  std::size_t i = 0;
  for (int y = low_.y; y < low_.y + options_.size; ++y) {
    const std::size_t begin = slot({0, y});
    auto column = static_cast<std::size_t>(modulo(low_.x, options_.size));
    for (int x = low_.x; x < low_.x + options_.size; ++x, ++i, column = column + 1 < size ? column + 1 : 0) {
      const float told = std::clamp(told_[i], -limit_, limit_);
      ViewMemory::Increments more{told, told};
      if (range_[i] < body_radius_) {
        more = {-2 * limit_, -2 * limit_};
        if (by_view) views_.set_free(begin + column);
      } else if (by_view && told != 0) {
        const int view = views_.view(bearing_[i] + turned, range_[i]);
        if (feeds)
          more = views_.increments(begin + column, {x, y}, view, told);
        else
          more.window = views_.increment(begin + column, view, told);
      }
      increments_[i] = more.window;
      if (feeds) everywhere_[i] = more.everywhere;
    }
  }
}

/// [CN] eq. (4) with eq. (5): the odds are multiplied, so their logarithms are added.
void LocalMap::update() {
  const auto size = static_cast<std::size_t>(options_.size);
  const auto column = static_cast<std::size_t>(modulo(low_.x, options_.size));
  for (std::size_t row = 0; row < size; ++row) {
    float* cells = cells_.data() + slot({0, low_.y + static_cast<int>(row)});
    const float* increments = increments_.data() + row * size;
    add_evidence(cells + column, increments, size - column, limit_);
    add_evidence(cells, increments + (size - column), column, limit_);
  }
}

Grid<float> LocalMap::log_odds() const {
  const double side = options_.resolution;
  Grid<float> window(options_.size, options_.size, 0, {side, {low_.x * side, low_.y * side, 0}});
  for (int y = 0; y < options_.size; ++y)
    for (int x = 0; x < options_.size; ++x) window[{x, y}] = cells_[slot({low_.x + x, low_.y + y})];
  return window;
}

std::size_t LocalMap::bytes() const {
  return sizeof(*this) + model_.bytes + views_.bytes() +
         (range_.capacity() + bearing_.capacity() + told_.capacity() + increments_.capacity() + everywhere_.capacity() +
          cells_.capacity()) *
             sizeof(float);
}

}  // namespace meander

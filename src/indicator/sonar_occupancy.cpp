// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/sonar_occupancy.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace meander {
namespace {

constexpr double kSure = 2.5;                 ///< evidence from which a cell counts as wall, or free
constexpr double kLeast = -20, kMost = 30;    ///< evidence is kept within
constexpr double kFree = -1.5, kWear = -0.3;  ///< of a cone: on a cell, on a certain wall
constexpr double kContact = 13;               ///< of a bumper that is pressed
constexpr double kRoom = 8, kRim = 4;         ///< room made around a point, the least that is left [m]
constexpr double kBetween = 0.6;              ///< so far out cones are taken to begin as wide as their distance [m]
constexpr int kFirstScans = 3;                ///< count although the robot has not moved
constexpr double kTurned = 0.1;               ///< a turn by this shows something else, too [rad]

Known known_by(double evidence, double suspect) {
  if (evidence < -kSure) return Known::free;
  return evidence > kSure ? Known::wall : evidence > suspect ? Known::suspected : Known::nothing;
}

}  // namespace

SonarOccupancy::SonarOccupancy(const Platform& platform, const SonarOccupancyOptions& options)
    : options_(options),
      ring_(platform.sonar),
      bumper_(platform.bumper),
      radius_(platform.body.radius),
      reach_(platform.body.radius + options.margin),
      tangent_(0),
      aperture_(ring_.radius * kPi / std::max(ring_.count, 1)),
      space_(0, 0, {options.resolution, {}}, reach_, reach_ + options.room) {
  validate(options);
  const SinCos half = sin_cos(options.half_cone);
  tangent_ = half.sin / half.cos;
}

void SonarOccupancy::update(const Observation& observation) {
  const Pose2& pose = observation.odometry.pose;
  include(pose.position());
  feel(observation);
  const bool moved = (pose.position() - last_).norm() >= options_.moved;
  const bool turned = std::abs(angle_between(last_heading_, pose.heading)) >= kTurned;
  if (scans_ >= kFirstScans && !moved && !turned) return;
  ++scans_;
  last_ = pose.position();
  last_heading_ = pose.heading;
  listen(observation);
  for (const Cone& cone : cones_) take_free(cone);
  if (moved)
    for (const Cone& cone : cones_) take_arc(cone);
  stand(pose.position());
}

void SonarOccupancy::listen(const Observation& observation) {
  const Readings& readings = observation.readings;
  cones_.clear();
  for (std::size_t i = 0; i < readings.sonar.size(); ++i) {
    const double bearing = ring_.first + 2 * kPi * static_cast<double>(i) / static_cast<double>(readings.sonar.size());
    const Pose2 robot = i < readings.sonar_pose.size() ? readings.sonar_pose[i] : observation.odometry.pose;
    const Vec2 axis = Pose2{0, 0, wrap_angle(robot.heading + bearing)}.direction();
    cones_.push_back({robot.position() + ring_.radius * axis, axis, readings.sonar[i]});
  }
}

/// Where the robot stands, nothing else does.
void SonarOccupancy::stand(const Vec2& at) {
  const GridFrame& frame = space_.frame();
  const double inside = std::max(radius_ - options_.resolution, 0.0);
  const Cell low = frame.cell(at - Vec2(radius_, radius_)), high = frame.cell(at + Vec2(radius_, radius_));
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      const double away = (frame.center({x, y}) - at).norm(), known = evidence({x, y});
      const bool under = away <= inside || (away <= radius_ && known <= kSure);  // a wall may be touched
      if (under && known > 2 * kFree) add({x, y}, 2 * kFree - known);
    }
}

void SonarOccupancy::feel(const Observation& observation) {
  const std::vector<std::uint8_t>& pressed = observation.readings.bumper;
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    if (!pressed[i]) continue;
    const double bearing = bumper_.first + 2 * kPi * static_cast<double>(i) / static_cast<double>(pressed.size());
    const Pose2& pose = observation.odometry.pose;
    const Vec2 out = Pose2{0, 0, wrap_angle(pose.heading + bearing)}.direction();
    add(space_.frame().cell(pose.position() + (radius_ + options_.resolution) * out), kContact);
  }
}

/// Calls visit(cell, distance) for the cells whose centre is in the cone and not farther than `reach`.
template <class Visit>
void SonarOccupancy::for_cells(const Cone& cone, double reach, Visit visit) {
  const GridFrame& frame = space_.frame();
  const Vec2 aside = tangent_ * Vec2(-cone.axis.y(), cone.axis.x());
  Vec2 low = cone.at, high = cone.at;
  for (const Vec2& corner : {Vec2(cone.axis + aside), Vec2(cone.axis - aside)}) {
    low = low.cwiseMin(cone.at + reach * corner);
    high = high.cwiseMax(cone.at + reach * corner);
  }
  low -= Vec2(aperture_, aperture_);
  high += Vec2(aperture_, aperture_);
  const Cell first = frame.cell(low), last = frame.cell(high);
  const Vec2 origin = frame.origin.position();
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) {
      const Vec2 to = origin + frame.resolution * Vec2(x + 0.5, y + 0.5) - cone.at;
      const double along = to.dot(cone.axis);
      const double across = std::abs(cone.axis.x() * to.y() - cone.axis.y() * to.x());
      const double distance = to.norm();
      if (along <= 0 || across > tangent_ * along + (distance < kBetween ? aperture_ : 0)) continue;
      if (distance <= reach) visit(Cell{x, y}, distance);
    }
}

void SonarOccupancy::take_free(const Cone& cone) {
  const double before = cone.reading >= options_.silent ? options_.silence : cone.reading - 0.05 - 0.025 * cone.reading;
  if (before <= 0) return;
  for_cells(cone, std::min(before, options_.range), [&](Cell cell, double) {
    if (!freed_.contains(cell) || freed_[cell] == scans_) return;
    freed_[cell] = scans_;
    add(cell, evidence(cell) > options_.hard ? kWear : kFree);
  });
}

/// The nearer, the shorter the arc, and the more it says of each cell.
void SonarOccupancy::take_arc(const Cone& cone) {
  if (cone.reading >= options_.arcs) return;
  const double off = 0.035 + 0.01 * cone.reading;
  for_cells(cone, cone.reading + off, [&](Cell cell, double distance) {
    if (distance <= cone.reading - off || !freed_.contains(cell) || freed_[cell] == scans_) return;
    add(cell, std::min(1.0, 0.7 / distance));
  });
}

void SonarOccupancy::add(Cell cell, double evidence) {
  if (!evidence_.contains(cell)) return;
  float& value = evidence_[cell];
  value = static_cast<float>(std::clamp(value + evidence, kLeast, kMost));
  space_.set(cell, known_by(value, options_.suspect));
}

void SonarOccupancy::raise(Cell cell, double evidence) {
  if (this->evidence(cell) < evidence) add(cell, evidence - this->evidence(cell));
}

void SonarOccupancy::forget(Cell cell) { add(cell, -evidence(cell)); }

ConfigurationSpace SonarOccupancy::without_weak() const {
  ConfigurationSpace space = space_;
  for (int y = 0; y < space.height(); ++y)
    for (int x = 0; x < space.width(); ++x)
      if (weak({x, y})) space.set({x, y}, Known::nothing);
  return space;
}

bool SonarOccupancy::has_room(const Vec2& point) const {
  return space_.width() > 0 && (point - low_).minCoeff() >= kRim && (high_ - point).minCoeff() >= kRim;
}

/// Its lower and its upper corner.
std::pair<Vec2, Vec2> SonarOccupancy::room_with(const Vec2& point) const {
  const Vec2 room(kRoom, kRoom), least = point - room, most = point + room;
  if (space_.width() == 0) return {least, most};
  return {low_.cwiseMin(least), high_.cwiseMax(most)};
}

double SonarOccupancy::cells_with(const Vec2& point) const {
  if (has_room(point)) return static_cast<double>(space_.width()) * space_.height();
  const auto [low, high] = room_with(point);
  return ((high - low) / options_.resolution + Vec2(2, 2)).prod();
}

void SonarOccupancy::include(const Vec2& point) {
  if (has_room(point)) return;
  if (!(cells_with(point) <= kMostCells))
    fail<Error>("sonar map: room around ({:g}, {:g}) m takes more than {:g} cells of {:g} m", point.x(), point.y(),
                kMostCells, options_.resolution);
  std::tie(low_, high_) = room_with(point);
  const double side = options_.resolution;
  low_ = side * Vec2(std::floor(low_.x() / side), std::floor(low_.y() / side));  // what is known moves by whole cells
  make_room(empty_room(low_, high_), std::move(evidence_));
}

Grid<float> SonarOccupancy::empty_room(const Vec2& low, const Vec2& high) const {
  const double side = options_.resolution;
  const auto cells = [&](double metres) { return static_cast<int>(std::floor(metres / side)); };
  return {cells(high.x() - low.x()) + 1, cells(high.y() - low.y()) + 1, 0, {side, {low.x(), low.y(), 0}}};
}

void SonarOccupancy::make_room(Grid<float> room, Grid<float> known) {
  const Cell shift = known.width() > 0 ? room.frame.cell(known.frame.center({0, 0})) : Cell{};
  space_ = ConfigurationSpace(room.width(), room.height(), room.frame, reach_, reach_ + options_.room);
  freed_ = Grid<std::int32_t>(room.width(), room.height(), 0, room.frame);
  evidence_ = std::move(room);
  for (int y = 0; y < known.height(); ++y)
    for (int x = 0; x < known.width(); ++x)
      if (known[{x, y}] != 0) add({x + shift.x, y + shift.y}, known[{x, y}]);
  ++frames_;
}

SonarOccupancy::Memory SonarOccupancy::memory() const { return {low_, high_, last_, last_heading_, scans_, evidence_}; }

void SonarOccupancy::restore(const Memory& memory) {
  low_ = memory.low;
  high_ = memory.high;
  last_ = memory.last;
  last_heading_ = memory.last_heading;
  scans_ = memory.scans;
  make_room(empty_room(low_, high_), memory.evidence);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_navigator.hpp"

#include <algorithm>
#include <cmath>

#include "polar/echo.hpp"
#include "robot/kinematics.hpp"

namespace meander {
namespace {

/// By how much ln v falls per metre of way: only finite volumes tell ways, other weights have no such number.
double ways_per_metre(const PolarMapOptions& map, const PolarParts& parts) {
  return map.weights == PolarWeights::finite_volume && !parts.weights ? map.kappa : 0;
}

constexpr int kFewScans = 2;       ///< of the last resort before turning in place
constexpr double kFaint = 1e-150;  ///< activation
constexpr double kLooking = 0.4;   ///< turning rate when there is no way [rad/s]
constexpr double kAligned = 0.05;  ///< [rad]
enum Layer : std::size_t { plan, hard, soft };

std::vector<RingWeights> weights_of(const PolarLayout& layout, const PolarMapOptions& map, const PolarParts& parts) {
  return parts.weights ? ring_weights(layout, parts.weights) : ring_weights(layout, map.weights, map.kappa);
}

PolarOptions checked(const PolarOptions& given, const Platform& platform) {
  validate(given);
  const PolarOptions options = in_mode(given);
  check(options, platform.body);
  return options;
}

/// Weights of other kinds know of sectors that are alike only.
std::optional<LayoutOrganiser> organiser_of(const PolarMapOptions& map, const PolarParts& parts) {
  if (map.layout.layout == PolarPlacing::fixed) return std::nullopt;
  if (map.weights != PolarWeights::finite_volume || parts.weights)
    fail("option 'map.layout': self_organising needs map.weights = \"finite_volume\"");
  return LayoutOrganiser(map.layout, map.organising);
}

std::size_t most_points(const Platform& platform, const PolarOptions& options) {
  return static_cast<std::size_t>(platform.sonar.count) * static_cast<std::size_t>(options.memory.scans);
}

}  // namespace

PolarNavigator::PolarNavigator(const Platform& platform, const PolarOptions& options, PolarParts parts)
    : platform_(platform),
      options_(checked(options, platform)),
      parts_(std::move(parts)),
      layout_(options_.map.layout),
      organiser_(organiser_of(options_.map, parts_)),
      memory_(platform, options_.memory),
      predictor_(platform, options_.prediction),
      mapper_(platform.body.radius, layout_.scope(), options_.map.merge, most_points(platform, options_)),
      control_layout_(organiser_ ? organiser_->fixed() : layout_),
      projection_(control_layout_,
                  {platform.body.radius + options_.map.margin, platform.body.radius + options_.control.hard_margin,
                   platform.body.radius + options_.control.soft_margin}),
      narrow_(layout_, {platform.body.radius + options_.map.narrow_margin}),
      organised_(layout_, {platform.body.radius + options_.map.margin}),
      solver_(layout_, weights_of(layout_, options_.map, parts_)),
      arranged_(solver_.weights()),
      readout_(options_.subgoal, ways_per_metre(options_.map, parts_)),
      control_(platform.body, options_.control, parts_.objective),
      trap_(platform, options_.trap),
      planned_(&projection_.layer(plan)) {
  check_decay();
}

/// A double has room for 300 decades: half of them for the way from the scope in the open leave half for ways round.
void PolarNavigator::check_decay() {
  const int rim = layout_.rings() - 1;
  solver_.solve(projection_.layer(plan), rim, {.passes = 1, .exact = false});
  if (solver_.activation(0, 0) >= kFaint) return;
  if (parts_.weights)
    fail("weights: too little activation arrives from the scope in the open ({:.1g}, at least {:g} expected)",
         solver_.activation(0, 0), kFaint);
  fail(
      "option 'map.kappa': with map.scope = {} m and {} rings a kappa expected with which at least {:g} of the "
      "activation "
      "arrives from the scope in the open, got {} ({:.1g} arrives)",
      layout_.scope(), layout_.rings(), kFaint, options_.map.kappa, solver_.activation(0, 0));
}

void PolarNavigator::reset() {
  memory_.clear();
  predictor_.reset();
  trap_.reset();
  direction_.reset();
  subgoal_.reset();
  control_.reset();
  predicted_ = {};
  odometry_from_map_ = {};
  target_distance_ = 0;
  target_ring_ = 0;
  planned_ = &projection_.layer(plan);
  mapped_ = false;
  if (!organiser_) return;
  organiser_->reset();
  layout_ = PolarLayout(options_.map.layout);
  finite_volumes(layout_, options_.map.kappa, arranged_);
  solver_.arrange(layout_, arranged_);
}

/// One control cycle, as [LM99, System Architecture] lists it.
NavigatorStep PolarNavigator::step(const Observation& observation, const Subgoal& subgoal) {
  memory_.remember(observation.readings);        // 1 sense, 2 remember
  predicted_ = predictor_.predict(observation);  // 3
  NavigatorStep step;
  const Vec2 at = observation.odometry.pose.position();
  TrapEscapes::Verdict trap =
      trap_.update(observation, subgoal.position, memory_, subgoal_ && subgoal_->position.y() >= 0);
  if ((subgoal.position - at).norm() <= subgoal.tolerance) {
    step = arrive(observation, subgoal);
  } else if (trap.give_up) {
    step = {{}, NavigatorStatus::trapped, std::move(trap.reason)};
  } else {
    step.reason = std::move(trap.reason);
    place_map(trap_.temporary().value_or(subgoal.position));
    map_points(observation);  // 4 project
    organise();
    project();               // 5 map
    diffuse();               // 6
    choose_subgoal();        // 7
    step.command = drive();  // 8
  }
  predictor_.commanded(step.command);
  return step;
}

NavigatorStep PolarNavigator::arrive(const Observation& observation, const Subgoal& subgoal) const {
  if (!subgoal.heading) return {{}, NavigatorStatus::arrived, {}};
  const double error = angle_between(predicted_.pose.heading, *subgoal.heading);
  if (std::abs(angle_between(observation.odometry.pose.heading, *subgoal.heading)) <= kAligned)
    return {{}, NavigatorStatus::arrived, {}};
  const Body& body = platform_.body;
  const double most = std::min(body.w_max, std::sqrt(2 * body.a_w * std::abs(error)));
  const double w = std::clamp(error / (2 * predicted_.period), -most, most);
  return {{0, w, 0}, NavigatorStatus::driving, {}};
}

/// The map lies around the predicted position with the target in sector 0.
void PolarNavigator::place_map(const Vec2& target) {
  mapped_ = true;
  const Vec2 way = target - predicted_.pose.position();
  target_distance_ = way.norm();
  target_ring_ = meander::target_ring(layout_, target_distance_);
  odometry_from_map_ = {predicted_.pose.x, predicted_.pose.y, angle_of(way.y(), way.x())};
}

void PolarNavigator::map_points(const Observation& observation) {
  const Vec2 at = observation.odometry.pose.position();
  if (!parts_.obstacles) return mapper_.map(memory_, odometry_from_map_, at);
  parts_.obstacles(observation, obstacles_);
  mapper_.map(obstacles_, odometry_from_map_, at);
}

/// [LM99+] Units move to where the readings are, and take their weights with them. The motion control keeps the fixed
/// layout: where units lie wide apart its margins would be too rough.
void PolarNavigator::organise() {
  if (!organiser_) return;
  organiser_->learn(mapper_.points());
  if (!organiser_->organise(layout_)) return;
  finite_volumes(layout_, options_.map.kappa, arranged_);
  solver_.arrange(layout_, arranged_);
  target_ring_ = meander::target_ring(layout_, target_distance_);
}

void PolarNavigator::project() {
  projection_.clear();
  // The controller looks no farther than its trajectories lead; two rings more for rounding to units.
  const double reach = control_.reach(predicted_) + 2 * layout_.scope() / layout_.rings();
  projection_.set_reach(hard, reach);
  projection_.set_reach(soft, reach);
  for (const MappedPoint& point : mapper_.points()) projection_.add(point.position);
  planned_ = &projection_.layer(plan);
  if (!organiser_) return;
  organised_.clear();
  for (const MappedPoint& point : mapper_.points()) organised_.add(point.position);
  planned_ = &organised_.layer(plan);
}

/// [LM99+] Where nothing reaches the robot: closer to the obstacles, and then by what was seen last alone.
void PolarNavigator::diffuse() {
  solver_.solve(*planned_, target_ring_, options_.solver);
  if (!reached()) retry(memory_.scans());
  if (!reached()) retry(kFewScans);
}

bool PolarNavigator::reached() const {
  for (int sector = 0; sector < layout_.sectors(); ++sector)
    if (solver_.activation(0, sector) > 0) return true;
  return false;
}

void PolarNavigator::retry(int scans) {
  narrow_.clear();
  for (const MappedPoint& point : mapper_.points())
    if (point.age < scans) narrow_.add(point.position);
  planned_ = &narrow_.layer(0);
  solver_.solve(*planned_, target_ring_, options_.solver);
}

void PolarNavigator::choose_subgoal() {
  PolarState state{layout_, solver_, target(), target_ring_, std::nullopt};
  if (direction_) state.previous = layout_.nearest_sector(*direction_ - odometry_from_map_.heading);
  subgoal_ = parts_.subgoal ? parts_.subgoal(state) : readout_(state);
  if (!subgoal_) return direction_.reset();
  direction_ = wrap_angle(odometry_from_map_.heading + layout_.bearing(subgoal_->sector));
}

Command PolarNavigator::drive() {
  if (!subgoal_) return turn_in_place();
  return control_.choose({predicted_, angle_between(odometry_from_map_.heading, predicted_.pose.heading),
                          subgoal_->position, mapper_.clearance(), control_layout_, projection_.layer(hard),
                          projection_.layer(soft)});
}

/// Brake and look around, towards the target first.
Command PolarNavigator::turn_in_place() const {
  const double to_target = angle_between(predicted_.pose.heading, odometry_from_map_.heading);
  return limited({0, to_target < 0 ? -kLooking : kLooking, 0}, platform_.body);
}

namespace {

/// The step of a polar navigator's contract: found again by polar_inside.
struct PolarStep {
  std::shared_ptr<PolarNavigator> inside;
  NavigatorStep operator()(const Observation& o, const Subgoal& s) const { return inside->step(o, s); }
};

}  // namespace

Navigator polar_navigator(const Platform& platform, const PolarOptions& options, PolarParts parts) {
  need_sonars("polar", platform);
  const auto inside = std::make_shared<PolarNavigator>(platform, options, std::move(parts));
  return {.name = "polar",
          .step = PolarStep{inside},
          .reset = [inside] { inside->reset(); },
          .body_radius = platform.body.radius};
}

std::shared_ptr<const PolarNavigator> polar_inside(const Navigator& navigator) {
  const PolarStep* step = navigator.step.target<PolarStep>();
  return step ? step->inside : nullptr;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/planned_route.hpp"

#include <algorithm>

#include "autonomy/unmapped_obstacles.hpp"

namespace meander {
namespace {

constexpr double kLook = 0.5;  ///< between two looks at what was heard [s]
/// A new path has so long, or so much way, to show that it leads past what was heard: subgoals that change all the time
/// lead nowhere, and the navigator would never notice.
constexpr double kPatience = 12;  // [s]
constexpr double kWay = 0.5;      // [m]

class PlannedRoute {
 public:
  PlannedRoute(std::shared_ptr<const PlanningMap> map, std::vector<Vec2> targets, const PlannedRouteOptions& options,
               const std::optional<Platform>& robot, const StopToken* stop)
      : map_(std::move(map)), targets_(std::move(targets)), options_(options), robot_(robot), stop_(stop) {
    if (robot_) unmapped_.emplace(*robot_, map_, options_.mapped);
  }

  GuideStep next(const Observation& observation, const NavigatorStep& navigator) {
    const Vec2 at = observation.odometry.pose.position();
    if (unmapped_) unmapped_->listen(observation);
    if (path_.empty() && !plan(at)) return finished(reason_);
    if (asked_ && navigator.status == NavigatorStatus::arrived && now_ + 1 == path_.size()) return finished("", true);
    watch(at);
    const bool stuck = asked_ && (navigator.status == NavigatorStatus::trapped || driven_ > allowed_);
    if (stuck) {
      if (!escape(at, navigator.reason)) return finished(reason_);
      tried_ = observation.time;
      tried_at_ = at;
    }
    if (map_->version != version_ && !still_clear() && !plan(at)) return finished(reason_);
    look(at, observation.time);
    advance(at);
    if (now_ + 1 == path_.size() && (path_.back() - at).norm() <= options_.tolerance) return finished("", true);
    asked_ = true;
    return {.subgoal = subgoal(), .success = false, .reason = {}, .reached = reached_};
  }

  void reset() { *this = PlannedRoute(map_, targets_, options_, robot_, stop_); }

 private:
  /// The map, what was heard beside it, and what the robot was trapped before.
  PlanningMap known() {
    PlanningMap known = *map_;
    for (const Box& box : traps_) set_solid(known, box, true);
    if (unmapped_)
      for (const Vec2& point : unmapped_->points())
        if (const Cell cell = known.solid.frame.cell(point); known.solid.contains(cell)) known.solid[cell] = 1;
    return known;
  }

  /// With all that is known, or with ever less of what is not in the map: it may have moved, or never been there.
  bool plan(const Vec2& at) {
    version_ = map_->version;
    do
      if (plan_by(known(), at)) return true;
    while (forget());
    return false;
  }
  bool forget() {
    if (traps_.size() > 1)
      traps_.erase(traps_.begin(), traps_.end() - 1);
    else if (unmapped_ && !unmapped_->points().empty())
      unmapped_->forget();
    else if (!traps_.empty())
      traps_.clear();
    else
      return false;
    return true;
  }

  Work work() const { return {.stop = stop_, .progress = {}}; }

  /// With the margin, or without it.
  bool plan_by(const PlanningMap& map, const Vec2& at) {
    Clearance clearance(map.solid, work());
    if (!plan_with(map, clearance, at, options_.margin) && !plan_with(map, clearance, at, 0)) return false;
    clearance_ = std::move(clearance);
    return true;
  }

  bool plan_with(const PlanningMap& map, const Clearance& clearance, const Vec2& at, double margin) {
    const double radius = options_.robot_radius + margin;
    const PlanningTask task{
        .start = nearest_free(map, clearance, at, radius), .targets = targets_, .robot_radius = radius};
    const Plan plan = make_plan(problem_on(map, task, work()), options_.planner, {}, PathKind::gradient, work());
    if (!plan.reason().empty()) {
      reason_ = "no path: " + plan.reason();
      return false;
    }
    path_ = plan.points();
    // The centre of the target's cell is not the target.
    const auto target = std::min_element(targets_.begin(), targets_.end(), [&](const Vec2& a, const Vec2& b) {
      return (a - path_.back()).norm() < (b - path_.back()).norm();
    });
    path_.push_back(*target);
    now_ = 0;
    reach_ = options_.reach;
    asked_ = false;
    return true;
  }

  /// A robot that touches a wall in the map stands in a blocked cell: the nearest free one within a metre is its start.
  Vec2 nearest_free(const PlanningMap& map, const Clearance& clearance, const Vec2& at, double radius) const {
    const Grid<std::uint8_t>& solid = map.solid;
    const double cells = radius / solid.frame.resolution;
    const double room = cells <= 0.5 ? 0.5 : std::sqrt(cells * cells + 0.5);
    const Cell here = solid.frame.cell(at);
    const int reach = static_cast<int>(std::ceil(1 / solid.frame.resolution));
    Vec2 best = at;
    double least = std::numeric_limits<double>::infinity();
    for (int y = here.y - reach; y <= here.y + reach; ++y)
      for (int x = here.x - reach; x <= here.x + reach; ++x) {
        const Vec2 center(x + 0.5, y + 0.5);
        const double away = (solid.frame.center({x, y}) - at).norm();
        if (away >= least || !solid.contains({x, y}) || clearance.of(center, center, room) < room) continue;
        least = away;
        best = solid.frame.center({x, y});
      }
    return best;
  }

  /// Nothing solid is nearer to the straight way than the robot's body, or than the robot is already.
  bool in_sight(const Vec2& from, const Vec2& to) const {
    const GridFrame& frame = map_->solid.frame;
    const Vec2 a = frame.in_cells(from), b = frame.in_cells(to);
    const double cells = std::min(options_.robot_radius / frame.resolution, std::max(clearance_->of(a), 0.0));
    return clearance_->of(a, b, cells) >= cells - 1e-9;
  }

  /// On to the farthest point of the path within reach that is in sight; at least past the one that was come near to.
  void advance(const Vec2& at) {
    const auto near = [&](std::size_t i) { return (path_[i] - at).norm() <= options_.hand_over; };
    if (asked_ && !near(now_)) return;
    if (asked_) {
      ++reached_;
      reach_ = options_.reach;
    }
    std::size_t from = now_;
    while (from + 1 < path_.size() && near(from)) ++from;
    double ahead = (path_[from] - at).norm();
    std::size_t best = from;
    for (std::size_t i = from; i < path_.size(); ++i) {
      if (i > from) ahead += (path_[i] - path_[i - 1]).norm();
      if (ahead > reach_) break;
      if (in_sight(at, path_[i])) best = i;
    }
    now_ = best;
    driven_ = 0;
    allowed_ = (path_[now_] - at).norm() + options_.detour;
    nearest_ = at;
  }

  /// How far it has driven for this subgoal, and where it was nearest to it.
  void watch(const Vec2& at) {
    if (asked_) driven_ += (at - before_).norm();
    before_ = at;
    if ((path_[now_] - at).norm() < (path_[now_] - nearest_).norm()) nearest_ = at;
  }

  /// Is the rest of the path still clear in the map as it is now?
  bool still_clear() {
    version_ = map_->version;
    clearance_.emplace(known().solid);
    const GridFrame& frame = map_->solid.frame;
    const double cells = options_.robot_radius / frame.resolution;
    for (std::size_t i = now_; i < path_.size(); ++i) {
      const Vec2 before = frame.in_cells(path_[i > now_ ? i - 1 : i]);
      if (clearance_->of(before, frame.in_cells(path_[i]), cells) < cells - 1e-9) return false;
    }
    return true;
  }

  /// Is something that was heard in the way of the rest of the path? [m]
  bool beside_path(const Vec2& at) const {
    for (std::size_t i = now_; i < path_.size(); ++i)
      if (unmapped_->beside(i > now_ ? path_[i - 1] : at, path_[i], options_.robot_radius)) return true;
    return false;
  }

  /// [LM99+] The local navigation gets past what the map does not show, but not out of a dead end between such things:
  /// a path round what was heard is taken as soon as there is one.
  void look(const Vec2& at, double time) {
    if (!unmapped_ || time < look_again_) return;
    look_again_ = time + kLook;
    unmapped_->points();
    if (!beside_path(at) || (time < tried_ + kPatience && (at - tried_at_).norm() < kWay)) return;
    tried_ = time;
    tried_at_ = at;
    plan_by(known(), at);
  }

  /// [LM99+] Something that nobody has heard yet may stand where the subgoal is: one half as far on the same path
  /// brings the robot to where it hears it, or past it.
  bool nearer(const Vec2& at) {
    const double half = (path_[now_] - at).norm() / 2;
    if (reach_ < options_.reach || half < options_.hand_over / 2) return false;
    reach_ = half;
    const auto end = path_.begin() + static_cast<std::ptrdiff_t>(now_) + 1;
    const auto here = std::min_element(path_.begin(), end, [&](const Vec2& a, const Vec2& b) {
      return (a - at).squaredNorm() < (b - at).squaredNorm();
    });
    now_ = static_cast<std::size_t>(here - path_.begin());
    asked_ = false;
    return true;
  }

  /// [LM99+] The map shows a way where the navigator found none, and nothing was heard in it: a square just ahead of
  /// where it came nearest to the subgoal is taken as blocked from now on.
  bool escape(const Vec2& at, const std::string& why) {
    if (trapped_++ >= options_.replans) {
      reason_ = fmt::format("trapped at ({:.2f}, {:.2f}), after {} new paths{}{}", at.x(), at.y(), options_.replans,
                            why.empty() ? "" : ": ", why);
      return false;
    }
    if (unmapped_ && nearer(at)) return true;
    const Vec2 way = path_[now_] - nearest_;
    const double far = options_.robot_radius + options_.trap_size / 2;
    const Vec2 center = nearest_ + way * (way.norm() > far ? far / way.norm() : 1.0);
    const Vec2 half(options_.trap_size / 2, options_.trap_size / 2);
    traps_.push_back({center - half, center + half});
    return plan(at);
  }

  Subgoal subgoal() const {
    const bool last = now_ + 1 == path_.size();
    return {.position = path_[now_],
            .tolerance = last ? options_.tolerance : std::min(options_.tolerance, options_.hand_over)};
  }
  GuideStep finished(const std::string& why, bool success = false) const {
    return {.subgoal = {},
            .success = success,
            .reason = success ? "target reached" : why,
            .reached = reached_ + (success ? 1 : 0)};
  }

  std::shared_ptr<const PlanningMap> map_;
  std::vector<Vec2> targets_;
  PlannedRouteOptions options_;
  std::optional<Platform> robot_;
  const StopToken* stop_;
  std::optional<UnmappedObstacles> unmapped_;
  double look_again_ = 0, tried_ = -kPatience;  ///< [s]
  Vec2 tried_at_{0, 0};
  std::vector<Vec2> path_;  ///< [m]
  std::optional<Clearance> clearance_;
  double reach_ = options_.reach;  ///< less after a trap [m]
  std::size_t now_ = 0;            ///< the path's point that is the subgoal
  std::uint64_t version_ = 0;
  std::vector<Box> traps_;
  int trapped_ = 0;  ///< how often
  bool asked_ = false;
  Vec2 before_{0, 0}, nearest_{0, 0};
  double driven_ = 0, allowed_ = 0;  ///< for this subgoal [m]
  int reached_ = 0;
  std::string reason_;
};

}  // namespace

Guide planned_route(std::shared_ptr<const PlanningMap> map, std::vector<Vec2> targets,
                    const PlannedRouteOptions& options, const std::optional<Platform>& robot, const StopToken* stop) {
  validate(options);
  check_planner(options.planner, map->difficulty.cells().empty() && map->drag.cells().empty());
  if (robot) validate(*robot);
  if (targets.empty()) fail("targets: at least one expected, got none");
  auto route = std::make_shared<PlannedRoute>(std::move(map), std::move(targets), options, robot, stop);
  return {.name = "planned_route",
          .next = [route](const Observation& o, const NavigatorStep& n) { return route->next(o, n); },
          .reset = [route] { route->reset(); }};
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/sonar_explorer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "indicator/grid_way.hpp"

namespace meander {
namespace {

constexpr int kFirstScans = 3;        ///< it listens before it decides
constexpr double kGoalSight = 3;      ///< a free way to the goal of so much is taken at once [m]
constexpr double kLeastAhead = 0.35;  ///< whether in sight or not: nearer, the robot would stand still [m]
constexpr double kProgress = 0.1;     ///< [m]
constexpr double kBehind = 10;        ///< ways are looked for so far beyond the straight distance [m]
constexpr double kDear = 4;           ///< and they may be so much dearer than they are long
constexpr int kTakenBack = 3;         ///< so often in a run it tries again where it was stopped

}  // namespace

SonarExplorer::SonarExplorer(const Vec2& goal, const Platform& platform, const SonarExplorerOptions& options)
    : goal_(goal),
      platform_(platform),
      options_(options),
      map_(platform, options.map),
      sight_(options.ports, options.sight),
      perception_(options.ports),
      way_(platform, options.profile),
      explorer_(goal, options.explorer) {
  validate(options);
  if (platform.sonar.count == 0) fail("robot: one with sonars expected, '{}' has none", platform.name);
  map_.include(goal);
  if (by_profile()) return;
  explorer_.perceive = [this](IndicatorGraph& graph, IndicatorId here) {
    sight_.look(graph, here, map_.space(), goal_);
    link_driven(graph, here);
  };
}

void SonarExplorer::begin() {
  explorer_.begin();
  sight_.begin();
  doors_.begin(map_, explorer_.state().run, options_.explorer.recheck);
  way_.begin();
  look_ = {};
  set_down_ = false;
  from_.reset();
  toward_ = Toward::nothing;
  tried_.begin();
  taken_back_ = 0;
  walked_ = told_ = checked_ = 0;
  reached_ = blocked_ = 0;
  ending_ = Ending::driving;
  reason_.clear();
}

/// One control cycle. [DG] item 1, the motion between indicators, is the navigator's; items 2 to 7 are decide().
GuideStep SonarExplorer::next(const Observation& observation, const NavigatorStep& navigator) {
  if (explorer_.state().run == 0) begin();
  sense(observation);
  const double time = observation.time;
  const bool listening = map_.scans() < kFirstScans;
  if (ending_ == Ending::driving && !listening) {
    if ((at_ - goal_).norm() <= options_.arrive) drive_to(Toward::goal, goal_);
    if (by_profile()) follow_profile();
    if (toward_ != Toward::nothing && is_blocked(navigator, time)) {
      block_ahead();
      decide(true);
    } else if (toward_ == Toward::nothing || is_there() || !(goes_to_goal() || still_worth_it())) {
      decide(false);
    }
  }
  std::optional<Subgoal> to;
  for (int i = 0; i < 4 && ending_ == Ending::driving && !listening && !(to = subgoal()); ++i) decide(false);
  if (ending_ != Ending::driving)
    return {.subgoal = {}, .success = ending_ == Ending::reached, .reason = reason_, .reached = reached_};
  return {.subgoal = to ? to : Subgoal{.position = at_}, .success = false, .reason = {}, .reached = reached_};
}

void SonarExplorer::sense(const Observation& observation) {
  const Vec2 at = observation.odometry.pose.position();
  if (std::exchange(set_down_, true)) walked_ += (at - at_).norm();
  if (!std::isfinite(since_) || toward_ == Toward::nothing) since_ = observation.time;
  at_ = at;
  if (!(map_.cells_with(at) <= SonarOccupancy::kMostCells))
    fail<Error>(
        "goal: ({:g}, {:g}) m is too far from the robot at ({:g}, {:g}) m, a map of both has more than {:g} "
        "cells of {:g} m",
        goal_.x(), goal_.y(), at.x(), at.y(), SonarOccupancy::kMostCells, options_.map.resolution);
  map_.update(observation);
  if (by_profile()) way_.hear(observation);
  if (std::exchange(frames_, map_.frames()) == map_.frames()) return;
  field_.clear();
  nearest_ = std::numeric_limits<double>::infinity();
  free_space_.forget();
  sight_.move_cells();
  perception_ = MapPerception(options_.ports);
}

/// As soon as a free way to the goal is known it is taken.
bool SonarExplorer::goes_to_goal() {
  if (toward_ == Toward::goal) return true;
  if ((goal_ - at_).norm() > kGoalSight) return false;
  const ConfigurationSpace& space = map_.space();
  near_goal_.spread(space, cells_at(space, goal_, options_.arrive, false), kGoalSight);
  if (!nearest_reached(space, near_goal_, at_, 0.15)) return false;
  drive_to(Toward::goal, goal_);
  return true;
}

bool SonarExplorer::is_there() const {
  if (by_profile() && toward_ == Toward::port) return false;  // the profile tells
  const bool beside = toward_ == Toward::indicator && !by_profile();
  const double near = beside ? options_.explorer.same : options_.arrive;
  return (aim_ - at_).norm() <= near;
}

/// A way that was seen to be blind meanwhile is not driven to its end.
bool SonarExplorer::still_worth_it() {
  const ConfigurationSpace& space = map_.space();
  const bool closed = toward_ == Toward::port && space.blocked(space.frame().cell(aim_));
  if (walked_ - checked_ < options_.check && !closed) return true;
  checked_ = walked_;
  if (toward_ == Toward::frontier) {
    if (options_.strategy == ExplorationStrategy::dstar_lite) return false;
    const Cell aim = space.frame().cell(aim_);
    for (int y = aim.y - 3; y <= aim.y + 3; ++y)
      for (int x = aim.x - 3; x <= aim.x + 3; ++x)
        if (space.frontier({x, y})) return true;
    return false;
  }
  if (toward_ != Toward::port || !explorer_.state().at || by_profile()) return true;
  const std::vector<IndicatorId> ids = explorer_.graph().ids();
  places_.clear();
  for (const IndicatorId id : ids) places_.push_back(explorer_.graph().get(id).position);
  const auto here = std::find(ids.begin(), ids.end(), *explorer_.state().at) - ids.begin();
  for (const MapPort& port : perception_.ports(space, places_, static_cast<std::size_t>(here), goal_))
    if ((port.position - aim_).norm() <= 2 * options_.sight.keep) return true;
  return false;
}

/// Where it stands, or the nearest place where it can stand for all that is known.
Vec2 SonarExplorer::standing() const {
  const auto cell = nearest_free(map_.space(), at_, kSnap);
  return cell && !map_.space().free(map_.space().frame().cell(at_)) ? map_.space().frame().center(*cell) : at_;
}

/// [DG] items 2 to 7, where the way it was on has ended. A port that is chosen where the robot stands already was
/// approached in vain.
void SonarExplorer::decide(bool blocked) {
  if (options_.strategy != ExplorationStrategy::indicators) return decide_without_graph(blocked);
  for (int i = 0; i < 20; ++i) {
    Percept percept;
    percept.position = (at_ - goal_).norm() <= options_.arrive ? goal_ : standing();
    if (toward_ == Toward::indicator && is_there()) percept.position = aim_;
    percept.walked = walked_ - told_;
    percept.blocked = blocked;
    if (by_profile()) perceive_by_profile(percept);
    told_ = walked_;
    if (blocked && toward_ == Toward::indicator && explorer_.decision().out.port < 0)  // [DG] section 2, item 6
      sight_.close(explorer_.graph(), explorer_.decision().out.indicator, *explorer_.decision().to);
    const Decision& decision = explorer_.step(percept);
    toward_ = Toward::nothing;
    if (decision.ending == Ending::reached && (at_ - goal_).norm() > options_.explorer.tolerance) {
      explorer_.resume();  // the indicator is at the goal, the robot is not
      return drive_to(Toward::goal, goal_);
    }
    if (decision.ending == Ending::no_passable_direction) return look_again();
    if (decision.ending != Ending::driving) return end(decision.ending, decision.reason);
    if (by_profile() && decision.back) return drive_to(Toward::indicator, explorer_.graph().get(*decision.to).position);
    blocked = !decision.back && !follow(decision);
    if (!blocked && !decision.back) return;
  }
}

/// [DG] section 2, item 2: it is linked with the indicator before, even where the map does not see so far.
void SonarExplorer::link_driven(IndicatorGraph& graph, IndicatorId here) {
  if (from_) sight_.drove(graph, *from_, here, walked_ - from_walked_);
  from_ = here;
  from_walked_ = walked_;
}

/// False: the robot stands where the way begins that it is to take.
bool SonarExplorer::follow(const Decision& decision) {
  if (by_profile() && !decision.to) {
    ++reached_;
    way_.leave(decision.direction);
    drive_to(Toward::port, way_.aim());
    return true;
  }
  const bool port = decision.out.port >= 0 && !by_profile();
  const Vec2 place =
      port ? port_position(explorer_.graph(), decision.out) : explorer_.graph().get(*decision.to).position;
  if (port && (place - at_).norm() <= options_.arrive) return false;
  ++reached_;
  drive_to(port ? Toward::port : Toward::indicator, place);
  return true;
}

void SonarExplorer::drive_to(Toward toward, const Vec2& place) {
  if (toward == Toward::goal && toward_ == toward) return;
  toward_ = toward;
  aim_ = place;
  checked_ = walked_;
  nearest_ = std::numeric_limits<double>::infinity();
  since_ = std::numeric_limits<double>::infinity();  // from the next cycle on
}

/// [DG+] Ports alone do not say that a goal is out of reach: the whole map has to, weak walls are looked at first, and
/// where the robot did not get on is no wall.
void SonarExplorer::look_again() {
  if (look_.count() < options_.second_looks) {
    auto place = look_.next(map_, at_, goal_, options_.arrive);
    if (!place && tried_.take_back(map_)) {
      look_.reopen();
      place = look_.next(map_, at_, goal_, options_.arrive);
      if (place && ++taken_back_ > kTakenBack)
        return end(Ending::trapped,
                   fmt::format("stopped {} times: no way is left on which the robot got on, and whether "
                               "it could get on where it was stopped is not settled",
                               blocked_));
    }
    if (place) {
      if (options_.strategy == ExplorationStrategy::indicators) explorer_.resume();
      return drive_to(*place == goal_ ? Toward::goal : Toward::look, *place);
    }
    return end(Ending::no_passable_direction,
               fmt::format("no passable direction left: no way leads to the goal, with unknown taken as passable, "
                           "after {} second looks",
                           look_.count()));
  }
  end(Ending::budget,
      fmt::format("the budget of {} second looks is spent: no passable direction is left, and whether a "
                  "way leads to the goal through what is unknown is not settled",
                  options_.second_looks));
}

/// The navigator says so, or the robot stands still, or it comes no nearer to what it drives to for long.
bool SonarExplorer::is_blocked(const NavigatorStep& navigator, double time) {
  constexpr double kStill = 0.25;    // [m]
  constexpr double kRoundabout = 4;  // as much more patience with a robot that moves
  if (!std::isfinite(since_)) {
    since_ = moved_ = time;
    anchor_ = at_;
    return false;
  }
  if ((at_ - anchor_).norm() > kStill) {
    anchor_ = at_;
    moved_ = time;
  }
  const double left = way_left();
  if (left < nearest_ - kProgress) {
    nearest_ = left;
    since_ = moved_ = time;
  }
  return navigator.status == NavigatorStatus::trapped || time - moved_ > options_.patience ||
         time - since_ > kRoundabout * options_.patience;
}

/// A wall across the way, where the robot's front is, whatever the map said before: so no link leads there any more
/// ([DG] section 2, item 6).
void SonarExplorer::block_ahead() {
  ++blocked_;
  tried_.stop(map_, at_, ahead_);
}

/// Over cells that are known to be free; on a second look and where D* Lite plans, over unknown ones too. Empty: no way
/// leads there any more.
std::vector<Cell> SonarExplorer::way_to_aim() {
  const ConfigurationSpace& space = map_.space();
  if (by_dstar_lite()) return way_by_dstar_lite();
  const bool far = toward_ == Toward::frontier || toward_ == Toward::look, unknown = toward_ == Toward::look;
  field_.spread(space, ends(), far ? 1e9 : kDear * ((aim_ - at_).norm() + kBehind), unknown, WayCost::room,
                unknown ? &look_.closed_before(space) : nullptr, space.frame().cell(at_));
  const auto here = nearest_reached(space, field_, at_, kSnap);
  return here ? way_down(field_, *here) : std::vector<Cell>{};
}

/// Where the way to the aim may end.
std::vector<Cell> SonarExplorer::ends() const {
  const ConfigurationSpace& space = map_.space();
  if (toward_ == Toward::look) return {space.frame().cell(aim_)};
  if (toward_ == Toward::goal) return cells_at(space, goal_, options_.arrive, false);
  const auto near = nearest_free(space, aim_, kSnap / 2);
  return near ? std::vector<Cell>{*near} : std::vector<Cell>{};
}

/// Of the way that was planned in the last cycle [m].
double SonarExplorer::way_left() const {
  if (by_dstar_lite()) return free_space_.length();
  const auto here = nearest_reached(map_.space(), field_, at_, kSnap);
  return here ? field_.at(*here) : nearest_;
}

/// The farthest point in sight on the way to the aim, not farther than `ahead`. None: no free way leads there any more.
std::optional<Subgoal> SonarExplorer::subgoal() {
  if (toward_ == Toward::nothing) return std::nullopt;
  if (by_profile() && toward_ == Toward::port) return Subgoal{.position = ahead_ = aim_, .tolerance = 0.05};
  const ConfigurationSpace& space = map_.space();
  const std::vector<Cell> way = way_to_aim();
  if (way.empty()) return std::nullopt;
  Cell best = way.front();
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double away = (space.frame().center(way[i]) - at_).norm();
    if (away > options_.ahead) break;
    if (away <= kLeastAhead || straight_way(space, way.front(), way[i])) best = way[i];
  }
  const bool beside = toward_ == Toward::goal && !space.free(space.frame().cell(goal_));  // it cannot stand at its goal
  const bool last = best == way.back();
  ahead_ = last && !beside ? aim_ : space.frame().center(best);
  return Subgoal{.position = ahead_, .tolerance = last && beside ? space.resolution() / 2 : options_.arrive / 2};
}

void SonarExplorer::end(Ending ending, std::string reason) {
  ending_ = ending;
  reason_ = std::move(reason);
  toward_ = Toward::nothing;
}

namespace {

struct Exploration {
  std::shared_ptr<SonarExplorer> explorer;
  GuideStep operator()(const Observation& observation, const NavigatorStep& navigator) const {
    return explorer->next(observation, navigator);
  }
};

}  // namespace

std::shared_ptr<const SonarExplorer> explorer_of(const Guide& guide) {
  const auto* exploration = guide.next.target<Exploration>();
  return exploration ? exploration->explorer : nullptr;
}

Guide exploring_guide(const std::shared_ptr<SonarExplorer>& explorer) {
  return {.name = "explorer", .next = Exploration{explorer}, .reset = [explorer] { explorer->begin(); }};
}

}  // namespace meander

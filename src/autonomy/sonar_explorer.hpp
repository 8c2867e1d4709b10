// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>

#include "indicator/door_doubt.hpp"
#include "indicator/explorer.hpp"
#include "indicator/free_space_way.hpp"
#include "indicator/map_sight.hpp"
#include "indicator/profile_way.hpp"
#include "indicator/second_look.hpp"
#include "indicator/sonar_occupancy.hpp"
#include "indicator/tried_in_vain.hpp"
#include "robot/contracts.hpp"

namespace meander {

/// Who chooses where to go on the map that the sonars made: the indicators' rules, or one of those that they are
/// compared with, which have no graph.
enum class ExplorationStrategy { indicators, dstar_lite, frontier, goal_frontier };
template <>
struct EnumNames<ExplorationStrategy> {
  static constexpr std::pair<ExplorationStrategy, const char*> entries[] = {
      {ExplorationStrategy::indicators, "indicators"},
      {ExplorationStrategy::dstar_lite, "dstar_lite"},
      {ExplorationStrategy::frontier, "frontier"},
      {ExplorationStrategy::goal_frontier, "goal_frontier"}};
};

/// What the ports of indicators are read off: the accumulated map, or the polar profile of the place.
enum class PortPerception { map, profile };
template <>
struct EnumNames<PortPerception> {
  static constexpr std::pair<PortPerception, const char*> entries[] = {{PortPerception::map, "map"},
                                                                       {PortPerception::profile, "profile"}};
};

struct SonarExplorerOptions {
  ExplorationStrategy strategy = ExplorationStrategy::indicators;
  PortPerception perception = PortPerception::map;
  ExplorerOptions explorer{.same = 0.3, .evidence = 2, .decisions = 20000};
  SonarOccupancyOptions map;
  MapPerceptionOptions ports;
  SonarProfileOptions profile;
  MapSightOptions sight;
  double ahead = 0.7;
  double arrive = 0.2;
  double check = 0.35;
  double patience = 8;
  int second_looks = 200;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarExplorerOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"strategy", "",
              "who chooses: the indicators; D* Lite's shortest way with unknown as free; the frontier nearest to the "
              "robot, or "
              "nearest on the way to the goal"},
        o.strategy);
  visit(Field{"perception", "",
              "what ports are read off: the accumulated map, or, as in the paper, the polar profile of the place"},
        o.perception);
  fields(o.explorer, visit);
  visit(Field{"map", "", "the map that the sonars make"}, o.map);
  visit(Field{"ports", "", "how ports are read off the map"}, o.ports);
  visit(Field{"profile", "", "how ports are read off the polar profile"}, o.profile);
  visit(Field{"sight", "", "of which indicators the map is asked"}, o.sight);
  visit(Field{"ahead", "m", "subgoals are so far ahead on the way", 0.1, 100}, o.ahead);
  visit(Field{"arrive", "m", "a place is reached within this", 0.05, 10}, o.arrive);
  visit(Field{"check", "m", "after so much way it is checked whether what is driven to is still worth it", 0.05, 10},
        o.check);
  visit(Field{"patience", "s", "a way on which the robot comes no nearer for so long is blocked", 1, 1e6}, o.patience);
  visit(Field{"second_looks", "", "so often in a run it looks again before the goal is given up", 0, 1e6},
        o.second_looks);
}

/// [DG] on a robot: it listens, decides at each place where there is something to decide, and drives from there to the
/// next over cells that it knows to be free. What is known stays known from run to run. Sees observations, nothing
/// else.
class SonarExplorer {
 public:
  /// Throws ArgumentError when a number is out of range.
  SonarExplorer(const Vec2& goal, const Platform& platform, const SonarExplorerOptions& options = {});
  SonarExplorer(const SonarExplorer&) = delete;  // its graph's explorer calls it back
  SonarExplorer& operator=(const SonarExplorer&) = delete;

  void begin();
  GuideStep next(const Observation& observation, const NavigatorStep& navigator);

  Explorer& explorer() { return explorer_; }
  const Explorer& explorer() const { return explorer_; }
  const SonarOccupancy& map() const { return map_; }
  const Vec2& goal() const { return goal_; }
  const Platform& platform() const { return platform_; }
  const SonarExplorerOptions& options() const { return options_; }
  Ending ending() const { return ending_; }
  const std::string& reason() const { return reason_; }
  double walked() const { return walked_; }  ///< in this run [m]
  int blocked() const { return blocked_; }   ///< ways given up on the way, in this run
  int second_looks() const { return look_.count(); }

 private:
  friend std::string to_text(const SonarExplorer& explorer);
  friend std::shared_ptr<SonarExplorer> sonar_explorer_from_text(const std::string& text, const std::string& path);
  /// What it drives to.
  enum class Toward { nothing, goal, port, indicator, look, frontier };

  void sense(const Observation& observation);
  bool by_dstar_lite() const {
    return options_.strategy == ExplorationStrategy::dstar_lite && toward_ == Toward::frontier;
  }
  bool goes_to_goal();
  bool by_profile() const {
    return options_.perception == PortPerception::profile && options_.strategy == ExplorationStrategy::indicators;
  }
  void follow_profile();
  void perceive_by_profile(Percept& percept);
  bool is_there() const;
  bool still_worth_it();
  void decide(bool blocked);
  bool follow(const Decision& decision);
  void decide_without_graph(bool blocked);
  void give_up_frontier(const Vec2& place);
  bool decide_by_frontier();
  void link_driven(IndicatorGraph& graph, IndicatorId here);
  void look_again();
  void drive_to(Toward toward, const Vec2& place);
  bool is_blocked(const NavigatorStep& navigator, double time);
  void block_ahead();
  std::optional<Subgoal> subgoal();
  std::vector<Cell> way_to_aim();
  std::vector<Cell> ends() const;
  std::vector<Cell> way_by_dstar_lite();
  double way_left() const;
  Vec2 standing() const;
  void end(Ending ending, std::string reason);

  static constexpr double kSnap = 0.5;  ///< a place that is not free stands for the nearest that is, so far away [m]

  Vec2 goal_;
  Platform platform_;
  SonarExplorerOptions options_;
  SonarOccupancy map_;
  DoorDoubt doors_;
  TriedInVain tried_;
  MapSight sight_;
  MapPerception perception_;
  ProfileWay way_;
  int frames_ = 0;
  Explorer explorer_;
  SecondLook look_;
  GeodesicField field_, near_goal_;
  FreeSpaceWay free_space_;
  std::vector<Vec2> places_;

  std::optional<IndicatorId> from_;  ///< where it decided last
  double from_walked_ = 0;           ///< when it was there [m]
  Vec2 at_{0, 0};
  bool set_down_ = false;
  Toward toward_ = Toward::nothing;
  Vec2 aim_{0, 0};
  Vec2 ahead_{0, 0};
  double walked_ = 0, told_ = 0, checked_ = 0;  ///< [m]
  double nearest_ = 0, since_ = 0;              ///< to the aim by the way [m], time of the last progress [s]
  Vec2 anchor_{0, 0};
  double moved_ = 0;  ///< when it was last as far from the anchor as counts as motion [s]
  int reached_ = 0, blocked_ = 0, taken_back_ = 0;
  Ending ending_ = Ending::driving;
  std::string reason_;
};

/// The guide that it is: a reset begins a run.
Guide exploring_guide(const std::shared_ptr<SonarExplorer>& explorer);
/// The explorer that a guide is, or nullptr: who watches it shows what it has found so far.
std::shared_ptr<const SonarExplorer> explorer_of(const Guide& guide);

}  // namespace meander

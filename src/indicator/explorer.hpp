// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "indicator/exploration_rules.hpp"
#include "indicator/path_network.hpp"

namespace meander {

/// A way out that the robot perceives where it stands.
struct SeenPort {
  double direction = 0;  ///< in the odometry frame [rad]
  double reach = 0;      ///< open so far, as far as it can be seen [m]
};

/// What the robot perceives when it has come to a place where there is something to decide: more than two ways out, or
/// one alone, or an indicator that it knows, or the end of a way that is closed. Whoever drives it fills this in, be it
/// from a map, from a polar profile, or from the cells of a labyrinth.
struct Percept {
  Vec2 position{0, 0};            ///< in the odometry frame [m]
  std::vector<SeenPort> ports{};  ///< ways out of here, the one it came by among them
  std::optional<double> back{};   ///< direction of the way it came by [rad]; none: it was set down here
  double walked = 0;              ///< since the last decision [m]
  bool blocked = false;           ///< it cannot go on, wherever this is
};

/// How a run of the explorer ends.
enum class Ending { driving, reached, no_passable_direction, trapped, budget };
template <>
struct EnumNames<Ending> {
  static constexpr std::pair<Ending, const char*> entries[] = {{Ending::driving, "driving"},
                                                               {Ending::reached, "reached"},
                                                               {Ending::no_passable_direction, "no_passable_direction"},
                                                               {Ending::trapped, "trapped"},
                                                               {Ending::budget, "budget"}};
};

/// What the explorer wants next.
struct Decision {
  Ending ending = Ending::driving;  ///< driving: leave by `out`; else the run is over
  std::string reason;               ///< in words
  PortRef out;                      ///< of the indicator here; port -1: straight to `to`
  double direction = 0;             ///< in which it leaves [rad]
  std::optional<IndicatorId> to;    ///< where that leads, if it is known
  bool back = false;                ///< turn round: back to `to`, the indicator it left
  PortRef target;                   ///< what it is after: an unknown port, or (port -1) an indicator
};

/// What the explorer remembers beside its graph.
struct ExplorerState {
  int run = 0;                         ///< 0: no run was begun
  std::uint64_t decisions = 0;         ///< over all runs
  int in_run = 0;                      ///< decisions of this run
  double walked = 0;                   ///< in this run [m]
  int idle = 0;                        ///< decisions since the graph changed last
  bool reopened = false;               ///< in this run everything closed was opened once more
  bool fresh = false;                  ///< the indicator here was placed just now
  std::optional<IndicatorId> at;       ///< where it stands
  std::optional<int> came_by;          ///< port of it by which it came
  std::optional<PortRef> left_by;      ///< since the last decision it is on its way from here
  std::optional<IndicatorId> start;    ///< of this run
  std::optional<IndicatorId> at_goal;  ///< the indicator at the goal
  bool operator==(const ExplorerState&) const = default;
};

/// Explores with indicators, [DG] sections 2 and 3: told at each crossing and dead end what there is, it says by which
/// way to go on. Knows nothing of sensors and of driving.
class Explorer {
 public:
  /// Throws ArgumentError when a number is out of range.
  Explorer(const Vec2& goal, const ExplorerOptions& options = {});

  /// A run begins: the robot was set down somewhere. What is known stays known.
  void begin();
  /// One decision, [DG] section 2, items 2 to 7. Throws Error after the end of a run.
  const Decision& step(const Percept& percept);

  /// The run that was ended goes on: whoever drives knows better than to give the goal up.
  void resume() { decision_ = {}; }

  const IndicatorGraph& graph() const { return graph_; }
  const ExplorerOptions& options() const { return options_; }
  const Vec2& goal() const { return goal_; }
  const ExplorerState& state() const { return state_; }
  const Decision& decision() const { return decision_; }
  /// The known route from the start of the last run to the goal, if there is one.
  std::optional<Route> route() const;
  /// Nothing unknown can shorten that route by more than `eps`.
  bool proven() const;
  /// Is there an indicator at this position? Then passing it asks for a decision.
  bool knows(const Vec2& position) const;

  /// Continues from what a file tells.
  void restore(IndicatorGraph graph, const ExplorerState& state, Decision last = {});

  /// Where a map tells the ports of more indicators than the one here: called at each step, once the indicator here is
  /// placed, in the place of what the percept says of ports.
  std::function<void(IndicatorGraph&, IndicatorId here)> perceive;
  std::function<void(IndicatorId)> on_indicator;     ///< a new one was placed
  std::function<void(const Decision&)> on_decision;  ///< after each step

 private:
  const Decision& decide();
  bool way_is_closed(const Percept& percept) const;
  const Decision& turn_back();
  void arrive(const Percept& percept);
  void look(const std::vector<SeenPort>& seen);
  std::optional<int> nearest_port(double direction) const;
  void tie(double walked);
  const Decision& carry_out(const Intent& intent);
  const Decision& end(Ending ending, std::string reason);
  const Decision& told(Decision decision);
  bool reopen_all();
  bool spent(std::string& why) const;
  Situation situation() const;
  void find_ways();

  IndicatorGraph graph_;
  Vec2 goal_;
  ExplorerOptions options_;
  ExplorerState state_;
  Decision decision_;
  RouteLinks links_;
  std::uint64_t links_revision_ = ~std::uint64_t{0};
  PathNetwork from_here_, from_start_;
};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The explorer by sonar on a robot that drives, where a passage of its route closes between two runs.
#include <gtest/gtest.h>

#include "autonomy/sonar_explorer.hpp"
#include "labyrinth_robot.hpp"
#include "polar/polar_navigator.hpp"
#include "study/drive.hpp"
#include "world/generate_labyrinth.hpp"

namespace meander {
namespace {

constexpr int kSide = 5;
const Vec2 kGoal(kSide - 0.5, kSide - 0.5);

double length_of_way(const Labyrinth& cells) { return cells.steps_from({0, 0})[{kSide - 1, kSide - 1}]; }

/// Closes the passage that makes the way longest but leaves one; false: there is none.
bool close_a_door(Labyrinth& cells) {
  Labyrinth worst = cells;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (const int side : {0, 1}) {
        if ((side == 0 ? x : y) + 1 == kSide) continue;
        Labyrinth closed = cells;
        closed.set_open({x, y}, side, false);
        if (length_of_way(closed) > length_of_way(worst)) worst = closed;
      }
  const bool found = length_of_way(worst) > length_of_way(cells);
  cells = worst;
  return found;
}

/// A link by sight from one indicator to another, or infinite.
double link_between(const IndicatorGraph& graph, IndicatorId a, IndicatorId b) {
  double length = std::numeric_limits<double>::infinity();
  if (!graph.alive(a) || !graph.alive(b)) return length;
  for (const int index : graph.get(a).links) {
    const Link& link = graph.links()[static_cast<std::size_t>(index)];
    if (link.a.port < 0 && link.b.port < 0 && (link.a.indicator == b || link.b.indicator == b)) length = link.length;
  }
  return length;
}

/// The explorer's guide; watches what becomes of the links that it drives and finds blocked, and where it is stopped.
struct Watched {
  std::shared_ptr<SonarExplorer> explorer;
  std::vector<Vec2> stops{};
  int removed = 0;

  Guide guide() {
    Guide guide = exploring_guide(explorer);
    guide.next = [this, next = guide.next](const Observation& seen, const NavigatorStep& step) {
      const Explorer& rules = explorer->explorer();
      const Decision before = rules.decision();
      const bool by_sight = before.ending == Ending::driving && before.to && before.out.port < 0 && !before.back;
      const double length = by_sight ? link_between(rules.graph(), before.out.indicator, *before.to) : 0;
      const int stopped = explorer->blocked();
      const GuideStep said = next(seen, step);
      if (explorer->blocked() <= stopped) return said;
      stops.push_back(seen.odometry.pose.position());
      if (!by_sight) return said;
      ++removed;
      EXPECT_GT(link_between(rules.graph(), before.out.indicator, *before.to), length + 1e-9);
      return said;
    };
    return guide;
  }
};

TEST(SonarExplorerOnTheRobot, AWayThatWasDrivenAndFoundBlockedIsNoLinkAnyMore) {
  int closed = 0, removed = 0;
  for (std::uint64_t seed = 1; closed < 6; ++seed) {
    Labyrinth cells = make_labyrinth({.seed = seed, .columns = kSide, .rows = kSide, .loops = 0.2});
    Labyrinth after = cells;
    if (!close_a_door(after)) continue;
    ++closed;
    Watched watched{std::make_shared<SonarExplorer>(kGoal, labyrinth_robot().platform)};
    for (std::uint64_t run = 1; run <= 5; ++run) {
      const auto world = std::make_shared<World>(labyrinth_world(run < 4 ? cells : after, {}, seed));
      SimOptions options;
      options.seed = 10 * seed + run;
      Sim sim(world, {labyrinth_robot()}, options);
      watched.stops.clear();
      drive(sim, polar_navigator(labyrinth_robot().platform, {}), watched.guide(),
            {.time_limit = 600, .record_every = 0});
      EXPECT_EQ(watched.explorer->ending(), Ending::reached) << "seed " << seed << " run " << run;
      for (const Vec2& stop : watched.stops)
        EXPECT_LE(std::count_if(watched.stops.begin(), watched.stops.end(),
                                [&](const Vec2& other) { return (stop - other).norm() < 0.1; }),
                  2)
            << "seed " << seed << " run " << run << ": stopped ever again at " << stop.transpose();
    }
    removed += watched.removed;
  }
  EXPECT_GE(removed, 3);
}

}  // namespace
}  // namespace meander

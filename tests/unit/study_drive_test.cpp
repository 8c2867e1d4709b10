// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "autonomy/navigators.hpp"
#include "autonomy/subgoal_list.hpp"
#include "sim_worlds.hpp"

namespace meander {
namespace {

/// Turns to the subgoal and drives; blind.
Navigator beeline() {
  return {.name = "beeline", .step = [](const Observation& seen, const Subgoal& goal) -> NavigatorStep {
            const Vec2 to = inverse(seen.odometry.pose) * goal.position;
            const double error = angle_of(to.y(), to.x());
            return {{std::abs(error) < 0.3 ? 0.5 : 0, 1.5 * error, 0}, NavigatorStatus::driving, {}};
          }};
}

std::vector<Subgoal> places(const std::vector<Vec2>& positions) {
  std::vector<Subgoal> goals;
  for (const Vec2& p : positions) goals.push_back({.position = p, .tolerance = 0.2, .heading = {}, .name = {}});
  return goals;
}

Sim in_room() { return Sim(room(10, 6), {nomad(Pose2{1, 1, 0})}, {.seed = 4}); }

TEST(Drive, ReachesTheSubgoalsAndTellsHow) {
  Sim sim = in_room();
  const auto run = drive(sim, beeline(), subgoal_list(places({{5, 1}, {5, 4}})));
  EXPECT_TRUE(run.success);
  EXPECT_EQ(run.reason, "all subgoals reached");
  EXPECT_EQ(run.reached, 2);
  EXPECT_EQ(run.subgoals, 2);
  EXPECT_EQ(run.navigator, "beeline");
  EXPECT_EQ(run.seed, 4u);
  EXPECT_EQ(run.contacts, 0);
  EXPECT_EQ(run.goals.size(), 2u);
  EXPECT_NEAR(run.length, 4 + 3, 0.6);
  EXPECT_GT(run.turning, kPi / 2 - 0.3);
  EXPECT_NEAR(run.time, run.cycles * sim.period(), 1e-9);
  EXPECT_EQ(run.steps.size(), static_cast<std::size_t>(run.cycles));
  EXPECT_LT((run.steps.back().pose_world.position() - Vec2{5, 4}).norm(), 0.2);
  EXPECT_GT(run.cpu_per_cycle, 0);
}

TEST(Drive, NavigatorsMadeForAnotherBodyAreRefused) {
  Navigator made = beeline();
  made.body_radius = 0.15;
  Sim sim = in_room();
  const Guide guide = subgoal_list(places({{5, 1}}));
  try {
    drive(sim, made, guide);
    FAIL();
  } catch (const ArgumentError& error) {
    EXPECT_STREQ(error.what(), "navigator 'beeline': made for a robot of radius 0.15 m; this one has 0.2667 m");
  }
  made.body_radius = 0.2667;
  EXPECT_TRUE(drive(sim, made, guide).success);
  for (const std::string& name : navigator_names())
    EXPECT_EQ(navigator_by_name(name, nomad().platform).body_radius, 0.2667) << name;
}

TEST(Drive, SonarsTellTheirMaximum) {
  RobotOptions robot = nomad(Pose2{1, 1, 0});
  robot.sonar.range_max = 1.5;
  const Sim sim(room(10, 6), {robot}, {});
  EXPECT_EQ(sim.observation().readings.sonar_max, 1.5);
}

TEST(Drive, MetricsEqualThoseOfTheRecordedSteps) {
  Sim sim = in_room();
  const double first = sim.state().clearance;
  const auto run = drive(sim, beeline(), subgoal_list(places({{5, 1}, {2, 4}, {8, 5}})));
  double least = first, sum = first, turning = 0, heading = 0;
  for (const RunStep& step : run.steps) {
    least = std::min(least, step.clearance);
    sum += step.clearance;
    turning += std::abs(angle_between(heading, step.pose_world.heading));
    heading = step.pose_world.heading;
  }
  EXPECT_DOUBLE_EQ(run.clearance_min, least);
  EXPECT_NEAR(run.clearance_mean, sum / static_cast<double>(run.steps.size() + 1), 1e-12);
  EXPECT_NEAR(run.turning, turning, 1e-12);
}

TEST(Drive, JerkIsTheChangeOfAcceleration) {
  Sim sim = in_room();
  // Speeds 0.1, 0.2, 0.2, 0.1: accelerations 0.1, 0, -0.1 per cycle after the first.
  int cycle = 0;
  const double speeds[] = {0.1, 0.2, 0.2, 0.1};
  const Navigator scripted{.name = "scripted", .step = [&](const Observation&, const Subgoal&) -> NavigatorStep {
                             return {{speeds[cycle++], 0, 0}, NavigatorStatus::driving, {}};
                           }};
  const auto run = drive(sim, scripted, subgoal_list(places({{9, 5}})), {}, {}, [&](const Sim&) { return cycle < 4; });
  EXPECT_NEAR(run.jerk, (0.0 + 0.1 + 0.1) / 3 / (0.33 * 0.33), 1e-9);
  EXPECT_EQ(run.reason, "stopped by on_step");
}

TEST(Drive, SameSeedSameHashWhateverIsRecorded) {
  const auto hash = [](std::uint64_t seed, int every) {
    Sim sim(room(10, 6), {nomad(Pose2{1, 1, 0})}, {.seed = seed});
    return drive(sim, beeline(), subgoal_list(places({{5, 1}})), {.record_every = every}).hash;
  };
  EXPECT_EQ(hash(1, 1), hash(1, 0));
  EXPECT_EQ(hash(1, 1), hash(1, 3));
  EXPECT_NE(hash(1, 1), hash(2, 1));
}

TEST(Drive, AgainOnTheSameSimContinuesFromThere) {
  Sim sim = in_room();
  const Guide guide = subgoal_list(places({{4, 1}}));
  drive(sim, beeline(), guide);
  const double time = sim.time();
  const auto second = drive(sim, beeline(), subgoal_list(places({{4, 4}})));
  EXPECT_TRUE(second.success);
  EXPECT_NEAR(second.time, sim.time() - time, 1e-9);
  sim.reset();
  EXPECT_TRUE(drive(sim, beeline(), guide).success) << "guides are reset";
}

TEST(Drive, EndsAtTheTimeLimitAndAtContacts) {
  Sim sim = in_room();
  const auto late = drive(sim, beeline(), subgoal_list(places({{9, 5}})), {.time_limit = 2});
  EXPECT_FALSE(late.success);
  EXPECT_EQ(late.reason, "time limit of 2 s");
  EXPECT_NEAR(late.time, 2, 0.33);
  EXPECT_EQ(drive(sim, beeline(), subgoal_list(places({{9, 5}})), {.time_limit = 0}).cycles, 0);

  sim.reset();
  const auto hit = drive(sim, beeline(), subgoal_list(places({{12, 1}})), {.stop_on_contact = true});
  EXPECT_EQ(hit.reason, "contact");
  EXPECT_EQ(hit.contacts, 1);
  EXPECT_EQ(hit.fault_contacts, 1);
  EXPECT_NEAR(hit.clearance_min, 0, 1e-6);
}

TEST(Drive, CountsHowOftenTheNavigatorIsTrapped) {
  Sim sim = in_room();
  int cycle = 0;
  const Navigator moody{.name = "moody", .step = [&](const Observation&, const Subgoal&) -> NavigatorStep {
                          const bool trapped = cycle % 10 < 2;
                          ++cycle;
                          return {{}, trapped ? NavigatorStatus::trapped : NavigatorStatus::driving, {}};
                        }};
  const Guide guide = subgoal_list(places({{9, 5}}), {.when_trapped = WhenTrapped::insist});
  const auto run = drive(sim, moody, guide, {.time_limit = 30 * 0.33 - 0.1});
  EXPECT_EQ(run.cycles, 30);
  EXPECT_EQ(run.trapped, 3) << "a report that lasts counts once";
}

TEST(Drive, StopsWhenAskedWithTheStateIntact) {
  Sim sim = in_room();
  StopToken stop;
  int cycles = 0;
  EXPECT_THROW(drive(sim, beeline(), subgoal_list(places({{9, 5}})), {}, {&stop, {}},
                     [&](const Sim&) {
                       if (++cycles == 10) stop.request();
                       return true;
                     }),
               Cancelled);
  EXPECT_NEAR(sim.time(), 3.3, 1e-9);
}

TEST(Drive, OnStepMayEditTheWorld) {
  Sim sim = in_room();
  const auto run = drive(sim, beeline(), subgoal_list(places({{9, 1}})), {.time_limit = 30}, {}, [](const Sim& now) {
    if (now.time() > 3 && now.world().slots() == 1)
      now.shared_world()->add(Obstacle{.name = "", .shape = Rectangle{{6, 1}, {0.2, 2}, 0}, .surface = {}});
    return true;
  });
  EXPECT_FALSE(run.success);
  EXPECT_EQ(run.contacts, 1);
}

TEST(Drive, SeveralRobotsEachWithItsPilot) {
  Sim sim(room(10, 6), {nomad(Pose2{1, 1, 0}), nomad(Pose2{1, 4, 0}), nomad(Pose2{9, 5.5, 0})}, {});
  const std::vector<Pilot> pilots{{beeline(), subgoal_list(places({{4, 1}}))},
                                  {beeline(), subgoal_list(places({{8, 4}}))}};
  const auto runs = drive(sim, pilots);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_TRUE(runs[0].success);
  EXPECT_TRUE(runs[1].success);
  EXPECT_LT(runs[0].time, runs[1].time) << "who has finished stands and is not recorded on";
  EXPECT_EQ(sim.state(2).travelled, 0);
  const std::vector<Pilot> too_many(4, pilots[0]);
  EXPECT_THROW(drive(sim, too_many), ArgumentError);
}

}  // namespace
}  // namespace meander

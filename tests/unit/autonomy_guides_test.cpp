// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <limits>

#include "autonomy/navigators.hpp"
#include "autonomy/subgoal_list.hpp"
#include "base/names.hpp"

namespace meander {
namespace {

Observation at(double x, double y) {
  Observation observation;
  observation.odometry.pose = {x, y, 0};
  return observation;
}

std::vector<Subgoal> three() {
  return {{.position = {1, 0}, .tolerance = 0.25, .heading = {}, .name = "a"},
          {.position = {2, 0}, .tolerance = 0.25, .heading = {}, .name = "b"},
          {.position = {3, 0}, .tolerance = 0.25, .heading = {}, .name = "c"}};
}

NavigatorStep said(NavigatorStatus status, std::string reason = {}) { return {{}, status, std::move(reason)}; }

TEST(SubgoalListTest, HandsOutOneAfterTheOther) {
  const Guide guide = subgoal_list(three());
  EXPECT_EQ(guide.subgoals, 3);
  EXPECT_EQ(guide.next(at(0, 0), {}).subgoal->name, "a");
  EXPECT_EQ(guide.next(at(0.7, 0), {}).subgoal->name, "a");
  const GuideStep second = guide.next(at(0.76, 0), {});
  EXPECT_EQ(second.subgoal->name, "b");
  EXPECT_EQ(second.reached, 1);
  guide.next(at(2, 0), {});
  const GuideStep last = guide.next(at(3, 0.2), {});
  EXPECT_FALSE(last.subgoal);
  EXPECT_TRUE(last.success);
  EXPECT_EQ(last.reached, 3);
  EXPECT_EQ(last.reason, "all subgoals reached");
}

TEST(SubgoalListTest, HandsOverEarlyButNotTheLast) {
  const Guide guide = subgoal_list(three(), {.hand_over = 0.6});
  EXPECT_EQ(guide.next(at(0.5, 0), {}).subgoal->name, "b");
  EXPECT_EQ(guide.next(at(1.5, 0), {}).subgoal->name, "c");
  EXPECT_EQ(guide.next(at(2.5, 0), {}).subgoal->name, "c");
  EXPECT_TRUE(guide.next(at(2.8, 0), {}).success);
}

TEST(SubgoalListTest, TakesTheNavigatorsWordOnce) {
  const Guide guide = subgoal_list(three());
  guide.next(at(0, 0), {});
  EXPECT_EQ(guide.next(at(0, 0), said(NavigatorStatus::arrived)).subgoal->name, "b");
}

TEST(SubgoalListTest, IgnoresWordsFromBeforeTheFirstSubgoal) {
  const Guide guide = subgoal_list(three());
  EXPECT_EQ(guide.next(at(0, 0), said(NavigatorStatus::trapped)).subgoal->name, "a");
}

TEST(SubgoalListTest, GivesUpWithAReason) {
  const Guide guide = subgoal_list(three());
  guide.next(at(0, 0), {});
  const GuideStep end = guide.next(at(0, 0), said(NavigatorStatus::trapped, "walled in"));
  EXPECT_FALSE(end.subgoal);
  EXPECT_FALSE(end.success);
  EXPECT_EQ(end.reason, "trapped on the way to subgoal 1 'a' at (1.00, 0.00): walled in");
}

TEST(SubgoalListTest, OrSkipsAndSaysSo) {
  const Guide guide = subgoal_list(three(), {.when_trapped = WhenTrapped::skip});
  guide.next(at(0, 0), {});
  EXPECT_EQ(guide.next(at(0, 0), said(NavigatorStatus::trapped, "walled in")).subgoal->name, "b");
  guide.next(at(2, 0), {});
  const GuideStep end = guide.next(at(3, 0), {});
  EXPECT_FALSE(end.success);
  EXPECT_EQ(end.reached, 2);
  EXPECT_EQ(end.reason, "2 of 3 subgoals reached; trapped on the way to subgoal 1 'a' at (1.00, 0.00): walled in");
}

TEST(SubgoalListTest, OrInsists) {
  const Guide guide = subgoal_list(three(), {.when_trapped = WhenTrapped::insist});
  guide.next(at(0, 0), {});
  EXPECT_EQ(guide.next(at(0, 0), said(NavigatorStatus::trapped)).subgoal->name, "a");
  EXPECT_EQ(guide.next(at(1, 0), said(NavigatorStatus::driving)).subgoal->name, "b");
}

TEST(SubgoalListTest, AHeadingIsTheNavigatorsBusiness) {
  auto goals = three();
  goals.back().heading = 1;
  const Guide guide = subgoal_list(goals);
  guide.next(at(1, 0), {});
  guide.next(at(2, 0), {});
  EXPECT_EQ(guide.next(at(3, 0), {}).subgoal->name, "c");
  EXPECT_TRUE(guide.next(at(3, 0), said(NavigatorStatus::arrived)).success);
}

TEST(SubgoalListTest, ResetBeginsAnew) {
  const Guide guide = subgoal_list(three());
  guide.next(at(1, 0), {});
  guide.reset();
  const GuideStep first = guide.next(at(0, 0), {});
  EXPECT_EQ(first.subgoal->name, "a");
  EXPECT_EQ(first.reached, 0);
}

TEST(SubgoalListTest, RefusesNonsense) {
  EXPECT_THROW(subgoal_list({}), ArgumentError);
  auto bad = three();
  bad[1].position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(subgoal_list(bad), ArgumentError);
  bad = three();
  bad[2].tolerance = 0;
  EXPECT_THROW(subgoal_list(bad), ArgumentError);
  EXPECT_THROW(subgoal_list(three(), {.hand_over = -1}), ArgumentError);
}

TEST(Navigators, AreFoundByNameAndUnknownOnesAreListed) {
  for (const std::string& name : navigator_names()) EXPECT_EQ(navigator_by_name(name, platform("nomad200")).name, name);
  try {
    navigator_by_name("potential_feild", platform("nomad200"));
    FAIL();
  } catch (const ArgumentError& e) {
    EXPECT_EQ(e.what(), "unknown navigator 'potential_feild'; known: " + listing(navigator_names()) +
                            "; did you mean 'potential_field'?");
  }
}

}  // namespace
}  // namespace meander

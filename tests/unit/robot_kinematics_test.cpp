// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "robot/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.hpp"

namespace meander {
namespace {

void expect_same(const Pose2& a, const Pose2& b, double within) {
  EXPECT_NEAR(a.x, b.x, within);
  EXPECT_NEAR(a.y, b.y, within);
  EXPECT_NEAR(angle_between(a.heading, b.heading), 0, within);
}

struct Motion {
  Pose2 from;
  double v, w, dt;
};

Motion any_motion(Stream& random) {
  const Pose2 from{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-kPi, kPi)};
  const double w = random.chance(0.2) ? random.uniform(-1e-9, 1e-9) : random.uniform(-2, 2);
  return {from, random.uniform(-2, 2), w, random.uniform(0, 1)};
}

TEST(Arc, TwoHalvesMakeTheWhole) {
  Stream random(1, "arc");
  for (int i = 0; i < 2000; ++i) {
    const Motion m = any_motion(random);
    const double share = random.uniform();
    const Pose2 middle = arc(m.from, m.v, m.w, share * m.dt);
    expect_same(arc(middle, m.v, m.w, (1 - share) * m.dt), arc(m.from, m.v, m.w, m.dt), 1e-12);
  }
}

TEST(Arc, BackwardsComesHome) {
  Stream random(2, "arc");
  for (int i = 0; i < 2000; ++i) {
    const Motion m = any_motion(random);
    expect_same(arc(arc(m.from, m.v, m.w, m.dt), -m.v, -m.w, m.dt), m.from, 1e-12);
  }
}

TEST(Arc, MovesWithTheFrame) {
  Stream random(3, "arc");
  for (int i = 0; i < 2000; ++i) {
    const Motion m = any_motion(random);
    expect_same(m.from * arc({}, m.v, m.w, m.dt), arc(m.from, m.v, m.w, m.dt), 1e-12);
  }
}

TEST(Arc, FollowsItsCircle) {
  Stream random(4, "arc");
  for (int i = 0; i < 2000; ++i) {
    Motion m = any_motion(random);
    if (std::abs(m.w) < 1e-3) continue;
    const auto circle_center = [&](const Pose2& p) {
      return Vec2(p.position() + left_of(p.direction()) * (m.v / m.w));
    };
    const Vec2 before = circle_center(m.from);
    const Vec2 after = circle_center(arc(m.from, m.v, m.w, m.dt));
    EXPECT_NEAR((before - after).norm(), 0, 1e-10);
  }
}

TEST(Arc, EqualsASumOfTinyStraightSteps) {
  Pose2 pose{1, 2, 0.3};
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const double heading = pose.heading + 0.5 * 0.7 / kSteps;
    pose = {pose.x + 0.5 / kSteps * std::cos(heading), pose.y + 0.5 / kSteps * std::sin(heading),
            pose.heading + 0.7 / kSteps};
  }
  expect_same(arc({1, 2, 0.3}, 0.5, 0.7, 1), pose, 1e-9);
}

TEST(Ramped, MeanIsTheIntegralOfTheRamp) {
  Stream random(5, "ramp");
  for (int i = 0; i < 500; ++i) {
    const double from = random.uniform(-2, 2), to = random.uniform(-2, 2);
    const double rate = random.uniform(0.01, 3), dt = random.uniform(0.01, 2);
    const Ramped whole = ramped(from, to, rate, dt);
    constexpr int kParts = 1000;
    double value = from, sum = 0;
    for (int k = 0; k < kParts; ++k) {
      const double next = ramp(value, to, rate * dt / kParts);
      sum += 0.5 * (value + next) / kParts;
      value = next;
    }
    EXPECT_NEAR(whole.end, value, 1e-10);
    EXPECT_NEAR(whole.mean, sum, 1e-5);
  }
}

TEST(Ramped, NeverOvershootsNorOutrunsItsRate) {
  Stream random(6, "ramp");
  for (int i = 0; i < 2000; ++i) {
    const double from = random.uniform(-2, 2), to = random.uniform(-2, 2), rate = random.uniform(0.01, 3);
    const Ramped r = ramped(from, to, rate, 0.1);
    EXPECT_LE(std::abs(r.end - from), rate * 0.1 + 1e-12);
    EXPECT_GE((r.end - from) * (to - from), 0);
    EXPECT_LE(std::abs(to - r.end), std::abs(to - from));
  }
}

TEST(Ramped, InThePlaneIsNeverFasterThanBothEndsAndTheMeanIsTheIntegral) {
  Stream stream(6, "ramps");
  for (int i = 0; i < 2000; ++i) {
    const auto velocity = [&] {
      const SinCos t = sin_cos(stream.uniform(-kPi, kPi));
      return Vec2(stream.uniform(0, 0.25) * Vec2(t.cos, t.sin));
    };
    const Vec2 from = velocity(), to = velocity();
    const double rate = stream.uniform(0.01, 2), dt = stream.uniform(0.01, 1), most = std::max(from.norm(), to.norm());
    const RampedPlane whole = ramped(from, to, rate, dt);
    EXPECT_LE(whole.end.norm(), most + 1e-12);
    EXPECT_LE(whole.mean.norm(), most + 1e-12);
    EXPECT_LE((whole.end - from).norm(), rate * dt + 1e-12);
    EXPECT_NEAR(cross(whole.end - from, to - from), 0, 1e-12);
    Vec2 at = from, sum(0, 0);
    for (int k = 0; k < 8; ++k) {
      const RampedPlane part = ramped(at, to, rate, dt / 8);
      sum += part.mean / 8;
      at = part.end;
    }
    EXPECT_LT((at - whole.end).norm() + (sum - whole.mean).norm(), 1e-9);
  }
}

TEST(Limited, KeepsCommandsInsideAndMakesNonsenseZero) {
  const Body body = platform("nomad200").body;
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(limited({9, 9, 9}, body), (Command{body.v_max, body.w_max, 0}));
  EXPECT_EQ(limited({-1, -9, 0}, body), (Command{0, -body.w_max, 0}));
  EXPECT_EQ(limited({nan, inf, nan}, body), (Command{0, 0, 0}));
  EXPECT_EQ(limited({0.3, -0.2, 0}, body), (Command{0.3, -0.2, 0}));
}

TEST(Between, MeetsBothEndsAndTurnsTheShortWay) {
  const Pose2 from{0, 0, 3}, to{1, 2, -3};
  EXPECT_EQ(between(from, to, 0), from);
  EXPECT_EQ(between(from, to, 1), to);
  EXPECT_NEAR(std::abs(between(from, to, 0.5).heading), kPi, 1e-12);
}

TEST(Kinematics, OmnidirectionalBodiesGoAnyWayAtTheirFastest) {
  const Body& body = platform("alice").body;
  const Command fast = limited({3, 0.5, -4}, body);
  EXPECT_NEAR(fast.v, 0.6 * body.v_max, 1e-15);
  EXPECT_NEAR(fast.vy, -0.8 * body.v_max, 1e-15);
  EXPECT_EQ(fast.w, 0.5);
  EXPECT_EQ(limited({std::nan(""), 0, std::numeric_limits<double>::infinity()}, body), Command{});
  EXPECT_EQ(limited({0.2, 0, 0.2}, platform("nomad200").body).vy, 0);
}

TEST(Kinematics, TwistGoesRoundInACircle) {
  // Sideways with a quarter turn: the centre of the circle lies ahead, a radius of vy/w away.
  const Pose2 at = twist({1, 2, 0}, 0, 1, kPi / 2, 1);
  const double radius = 2 / kPi;
  EXPECT_NEAR(at.x, 1 - radius, 1e-12);
  EXPECT_NEAR(at.y, 2 + radius, 1e-12);
  EXPECT_NEAR(at.heading, kPi / 2, 1e-12);
}

TEST(PlatformTest, PresetsAreValidAndUnknownNamesAreListed) {
  for (const std::string& name : platform_names()) {
    EXPECT_EQ(platform(name).name, name);
    EXPECT_NO_THROW(validate(platform(name)));
    EXPECT_LE(platform(name).sonar.radius, platform(name).body.radius);
  }
  try {
    platform("nomad");
    FAIL();
  } catch (const ArgumentError& e) {
    EXPECT_STREQ(e.what(), "unknown platform 'nomad'; known: nomad200, scout, alice; did you mean 'nomad200'?");
  }
}

}  // namespace
}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Layouts whose sectors differ in width, and how they come about.
#include "polar/layout_organiser.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "polar/polar_lines.hpp"
#include "polar/polar_navigator.hpp"
#include "polar_support.hpp"

namespace meander {

std::size_t allocations();  // allocation_counter.cpp

namespace {

constexpr double kKappa = 20;
const PolarLayoutOptions kSizes[] = {
    {.rings = 40, .sectors = 24, .layout = PolarPlacing::self_organising},
    {.rings = 100, .sectors = 17, .layout = PolarPlacing::self_organising},
    {.rings = 12, .sectors = 16, .radii = PolarRadii::log, .layout = PolarPlacing::self_organising}};

std::vector<MappedPoint> mapped(std::uint64_t seed) {
  std::vector<MappedPoint> points;
  for (const Vec2& p : random_points(seed)) points.push_back({p, 0});
  return points;
}

PolarLayout organised(const PolarLayoutOptions& options, std::uint64_t seed) {
  PolarLayout layout(options);
  LayoutOrganiser organiser(options, {.share = 0.7});
  for (int cycle = 0; cycle < 100; ++cycle) organiser.learn(mapped(seed));
  EXPECT_TRUE(organiser.organise(layout));
  return layout;
}

PolarSolver solver_of(const PolarLayout& layout, const polar::LineKernels* kernels = nullptr) {
  return {layout, ring_weights(layout, PolarWeights::finite_volume, kKappa), kernels};
}

TEST(UnevenLayout, KeepsItsEndsAndItsOrderAndFindsItsUnits) {
  for (const PolarLayoutOptions& options : kSizes) {
    const PolarLayout layout = organised(options, 3), fixed({.rings = options.rings, .sectors = options.sectors});
    EXPECT_EQ(layout.radius(0), 0);
    EXPECT_EQ(layout.scope(), options.scope);
    EXPECT_EQ(layout.bearing(0), 0);
    double turn = 0;
    for (int r = 1; r < options.rings; ++r) EXPECT_GT(layout.radius(r), layout.radius(r - 1));
    for (int s = 0; s < options.sectors; ++s) {
      EXPECT_GT(layout.gap(s), fixed.spacing() / 6);
      EXPECT_LT(layout.gap(s), fixed.spacing() * 4);
      turn += layout.gap(s);
    }
    EXPECT_NEAR(turn, 2 * kPi, 1e-12);
    Stream random(1, "bearings");
    for (int k = 0; k < 2000; ++k) {
      const double bearing = random.uniform(-10, 10);
      double least = 10;
      for (int s = 0; s < options.sectors; ++s)
        least = std::min(least, std::abs(angle_between(bearing, layout.bearing(s))));
      const int found = layout.nearest_sector(bearing);
      EXPECT_NEAR(std::abs(angle_between(bearing, layout.bearing(found))), least, 1e-9);
    }
  }
}

TEST(UnevenLayout, ObstructsTheUnitsThatThePlainWayObstructs) {
  for (const PolarLayoutOptions& options : kSizes)
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const PolarLayout layout = organised(options, seed + 1);
      auto points = random_points(seed);
      points.push_back({0.05, 0.02});
      const Projection map = projected(layout, points);
      for (int s = 0; s < layout.sectors(); ++s)
        for (int r = 1; r + 1 < layout.rings(); ++r) {
          bool inside = false, doubtful = false;
          for (const Vec2& p : points) {
            const double gap =
                (layout.position(r, s) - p).norm() - std::min(0.3167, p.norm() - Projection::kCentreFree);
            inside = inside || gap <= 0;
            doubtful = doubtful || std::abs(gap) < 1e-12;
          }
          if (doubtful) continue;
          ASSERT_EQ(map.layer(0).test(r, s), inside) << seed << " ring " << r << " sector " << s;
        }
    }
}

/// The flows over a unit's four borders and what it loses, from the geometry alone: they make up its equation.
TEST(UnevenLayout, SolvesTheEquationOfItsVolumes) {
  for (const PolarLayoutOptions& options : kSizes)
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const PolarLayout layout = organised(options, seed + 5);
      const Projection map = projected(layout, random_points(seed));
      PolarSolver solver = solver_of(layout);
      const int last = layout.rings() - 1;
      solver.solve(map.layer(0), last, {.passes = 1, .exact = true});
      EXPECT_LT(solver.residual(map.layer(0)), 1e-12);
      for (int s = 0; s < layout.sectors(); ++s)
        for (int r = 1; r < last; ++r) {
          if (map.layer(0).test(r, s) || solver.activation(r, s) <= 0) continue;
          const double here = layout.radius(r), in = 0.5 * (here + layout.radius(r - 1)),
                       out = 0.5 * (here + layout.radius(r + 1)), width = layout.width(s);
          const int left = layout.wrapped(s - 1), right = layout.wrapped(s + 1);
          const double inward = in * width / (here - layout.radius(r - 1)),
                       outward = out * width / (layout.radius(r + 1) - here),
                       to_left = (out - in) / (here * layout.gap(left)), to_right = (out - in) / (here * layout.gap(s));
          const double total = inward + outward + to_left + to_right + kKappa * kKappa * here * width * (out - in);
          const double flow = inward * solver.activation(r - 1, s) + outward * solver.activation(r + 1, s) +
                              to_left * solver.activation(r, left) + to_right * solver.activation(r, right);
          ASSERT_NEAR(flow / total / solver.activation(r, s), 1, 1e-9) << seed << " ring " << r << " sector " << s;
        }
    }
}

TEST(UnevenLayout, AllKernelsGiveTheSameBits) {
  const auto kernels = polar::line_kernels();
  for (const PolarLayoutOptions& options : kSizes)
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const PolarLayout layout = organised(options, seed + 5);
      const Projection map = projected(layout, random_points(seed));
      PolarSolver plain = solver_of(layout, &kernels.front());
      plain.solve(map.layer(0), layout.rings() / 2);
      for (const polar::LineKernels& wide : kernels.subspan(1)) {
        PolarSolver solver = solver_of(layout, &wide);
        solver.solve(map.layer(0), layout.rings() / 2);
        for (int s = 0; s < layout.sectors(); ++s)
          for (int r = 0; r < layout.rings(); ++r)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(solver.activation(r, s)),
                      std::bit_cast<std::uint64_t>(plain.activation(r, s)))
                << wide.name << " seed " << seed;
      }
    }
}

TEST(LayoutOrganiser, PutsUnitsWhereTheReadingsAre) {
  const PolarLayoutOptions& options = kSizes[0];
  PolarLayout layout(options);
  LayoutOrganiser organiser(options, {});
  std::vector<MappedPoint> wall;
  for (int k = 0; k < 40; ++k) wall.push_back({Vec2(1.4 + 0.01 * k, 1.0), 0});
  EXPECT_FALSE(organiser.organise(layout)) << "nothing learnt yet";
  for (int cycle = 0; cycle < 300; ++cycle) organiser.learn(wall);
  ASSERT_TRUE(organiser.organise(layout));
  EXPECT_FALSE(organiser.organise(layout)) << "where it should be";
  const auto between = [&](const PolarLayout& l, double low, double high) {
    return l.first_ring_from(high) - l.first_ring_from(low);
  };
  const PolarLayout fixed({.rings = options.rings, .sectors = options.sectors});
  EXPECT_GE(between(layout, 1.7, 2.1), 2 * between(fixed, 1.7, 2.1));
  const int there = layout.nearest_sector(angle_of(1.0, 1.6)), behind = layout.nearest_sector(-2.5);
  EXPECT_LT(2 * layout.width(there), fixed.spacing());
  EXPECT_GT(layout.width(behind), 1.2 * fixed.spacing());
  organiser.reset();
  EXPECT_FALSE(organiser.organise(layout)) << "what was learnt is forgotten";
}

TEST(LayoutOrganiser, DrivesWithoutAllocations) {
  PolarOptions options;
  options.map.layout = {.rings = 40, .sectors = 24, .layout = PolarPlacing::self_organising};
  Navigator navigator = polar_navigator(platform("nomad200"), options);
  Stream random(1, "readings");
  Observation observation;
  observation.period = 0.33;
  observation.readings.sonar.resize(16);
  observation.readings.sonar_pose.resize(16);
  std::size_t before = 0;
  const std::vector<double> fixed = polar_inside(navigator)->layout().radii();
  for (int cycle = 0; cycle < 120; ++cycle) {
    observation.time += 0.33;
    observation.odometry.pose.x += 0.05;
    std::fill(observation.readings.sonar_pose.begin(), observation.readings.sonar_pose.end(),
              observation.odometry.pose);
    for (double& range : observation.readings.sonar) range = random.uniform(1.2, 1.6);
    if (cycle == 20) before = allocations();
    navigator.step(observation, {.position = {100, 1}, .tolerance = 0.25, .heading = {}, .name = {}});
  }
  EXPECT_EQ(allocations(), before);
  EXPECT_NE(polar_inside(navigator)->layout().radii(), fixed);
}

TEST(LayoutOrganiser, ANavigatorThatIsResetIsAsNew) {
  PolarOptions options;
  options.map.layout = {.rings = 40, .sectors = 24, .layout = PolarPlacing::self_organising};
  const Navigator used = polar_navigator(platform("nomad200"), options);
  const auto inside = polar_inside(used);
  const std::vector<double> fixed = inside->layout().radii();
  const auto drive = [](const Navigator& navigator, std::uint64_t seed, int cycles) {
    Stream random(seed, "readings");
    Observation seen;
    seen.period = 0.33;
    seen.readings.sonar.resize(16);
    std::vector<Command> commands;
    for (int cycle = 0; cycle < cycles; ++cycle) {
      seen.time += 0.33;
      seen.odometry.pose.x += 0.05;
      seen.readings.sonar_pose.assign(16, seen.odometry.pose);
      for (double& range : seen.readings.sonar) range = random.uniform(1.2, 1.6);
      commands.push_back(
          navigator.step(seen, {.position = {100, 1}, .tolerance = 0.25, .heading = {}, .name = {}}).command);
    }
    return commands;
  };
  EXPECT_FALSE(inside->mapped());
  drive(used, 1, 120);
  EXPECT_TRUE(inside->mapped());
  EXPECT_NE(inside->layout().radii(), fixed);
  used.reset();
  EXPECT_FALSE(inside->mapped());
  EXPECT_EQ(inside->layout().radii(), fixed);
  EXPECT_EQ(inside->target().x(), 0);
  EXPECT_EQ(inside->predicted().pose.x, 0);
  EXPECT_EQ(inside->control().chosen().command.v, 0);
  const Navigator fresh = polar_navigator(platform("nomad200"), options);
  for (const int cycles : {1, 2, 60}) {
    used.reset(), fresh.reset();
    const std::vector<Command> a = drive(used, 2, cycles), b = drive(fresh, 2, cycles);
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_TRUE(a[k].v == b[k].v && a[k].w == b[k].w) << k;
    for (int ring = 0; ring < 40; ++ring)
      for (int sector = 0; sector < 24; ++sector)
        ASSERT_EQ(inside->solver().activation(ring, sector), polar_inside(fresh)->solver().activation(ring, sector));
  }
}

TEST(LayoutOrganiser, WantsWeightsThatKnowOfWidths) {
  PolarOptions options;
  options.map.layout.layout = PolarPlacing::self_organising;
  options.map.weights = PolarWeights::lattice;
  EXPECT_THROW(polar_navigator(platform("nomad200"), options), ArgumentError);
}

}  // namespace
}  // namespace meander

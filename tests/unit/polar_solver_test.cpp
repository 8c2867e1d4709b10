// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The polar map's equilibrium, held against an independent direct solution, Dijkstra and its own laws.
#include <gtest/gtest.h>

#include <Eigen/SparseLU>
#include <bit>

#include "polar/polar_lines.hpp"
#include "polar/subgoal_readout.hpp"
#include "polar_support.hpp"

namespace meander {
namespace {

constexpr PolarSolverOptions kExact{.passes = 1, .exact = true};

struct Case {
  PolarLayoutOptions options;
  PolarWeights weights;
};
const Case kCases[] = {{{.rings = 100, .sectors = 48}, PolarWeights::finite_volume},
                       {{.rings = 100, .sectors = 32}, PolarWeights::finite_volume},
                       {{.rings = 32, .sectors = 32, .radii = PolarRadii::log}, PolarWeights::finite_volume},
                       {{.rings = 10, .sectors = 32}, PolarWeights::finite_volume},
                       {{.rings = 37, .sectors = 17}, PolarWeights::finite_volume},
                       {{.rings = 30, .sectors = 24}, PolarWeights::euclidean},
                       {{.rings = 30, .sectors = 24}, PolarWeights::lattice}};

/// The same equations, solved by elimination.
std::vector<double> direct(const PolarLayout& layout, const std::vector<RingWeights>& weights,
                           const ObstructedUnits& obstructed, int target) {
  const int n = layout.rings(), m = layout.sectors();
  std::vector<Eigen::Triplet<double>> terms;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n * m);
  right[target] = 1;
  const auto couple = [&](int row, int ring, int sector, double weight) {
    if (ring >= 0 && ring < n && weight > 0) terms.emplace_back(row, layout.wrapped(sector) * n + ring, -weight);
  };
  for (int s = 0; s < m; ++s)
    for (int r = 0; r < n; ++r) {
      const int row = s * n + r;
      if (row == target || obstructed.test(r, s)) {
        terms.emplace_back(row, row, 1.0);
        continue;
      }
      const RingWeights& w = weights[static_cast<std::size_t>(r)];
      terms.emplace_back(row, row, w.total);
      couple(row, r - 1, s, w.inward);
      couple(row, r + 1, s, w.outward);
      for (const int beside : {s - 1, s + 1}) {
        couple(row, r, beside, w.lateral);
        couple(row, r - 1, beside, w.inward_diagonal);
        couple(row, r + 1, beside, w.outward_diagonal);
      }
    }
  Eigen::SparseMatrix<double> matrix(n * m, n * m);
  matrix.setFromTriplets(terms.begin(), terms.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd v = solver.solve(right);
  return {v.data(), v.data() + v.size()};
}

TEST(PolarSolver, FindsTheEquilibriumThatEliminationFinds) {
  for (const Case& c : kCases) {
    const PolarLayout layout(c.options);
    const auto weights = ring_weights(layout, c.weights, 8);
    PolarSolver solver(layout, weights);
    for (const int target : {layout.rings() - 1, layout.rings() / 2, 1}) {
      const Projection map = projected(layout, random_points(3));
      solver.solve(map.layer(0), target, kExact);
      const auto reference = direct(layout, weights, map.layer(0), target);
      for (int s = 0; s < layout.sectors(); ++s)
        for (int r = 0; r < layout.rings(); ++r) {
          const double expected = reference[static_cast<std::size_t>(s * layout.rings() + r)];
          // Elimination is accurate relative to the largest value only.
          ASSERT_NEAR(solver.activation(r, s), expected, 1e-9 * std::abs(expected) + 1e-14)
              << c.options.rings << "x" << c.options.sectors << " target " << target << " ring " << r << " sector "
              << s;
        }
    }
  }
}

/// Registers of two, four or eight numbers: what this machine has, bit for bit.
TEST(PolarSolver, AllKernelsGiveTheSameBits) {
  const auto kernels = polar::line_kernels();
  ASSERT_STREQ(kernels.front().name, "portable");
  for (const Case& c : kCases) {
    const PolarLayout layout(c.options);
    const auto weights = ring_weights(layout, c.weights, 20);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Projection map = projected(layout, random_points(seed));
      const int target = seed % 3 == 0 ? layout.rings() / 2 : layout.rings() - 1;
      PolarSolver plain(layout, weights, &kernels.front());
      plain.solve(map.layer(0), target);
      for (const polar::LineKernels& wide : kernels.subspan(1)) {
        PolarSolver solver(layout, weights, &wide);
        solver.solve(map.layer(0), target);
        for (int s = 0; s < layout.sectors(); ++s)
          for (int r = 0; r < layout.rings(); ++r)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(solver.activation(r, s)),
                      std::bit_cast<std::uint64_t>(plain.activation(r, s)))
                << wide.name << " " << c.options.rings << "x" << c.options.sectors << " seed " << seed;
      }
    }
  }
}

TEST(PolarSolver, SaysHowFarFromTheEquilibriumItIs) {
  const PolarLayout layout({});
  PolarSolver solver(layout, ring_weights(layout, PolarWeights::finite_volume, 20));
  const Projection map = projected(layout, random_points(5));
  double last = 2;
  for (const int passes : {2, 8, 30}) {
    solver.solve(map.layer(0), 99, {.passes = passes});
    EXPECT_LT(solver.residual(map.layer(0)), last);
    last = solver.residual(map.layer(0));
  }
  solver.solve(map.layer(0), 99, kExact);
  EXPECT_LT(solver.residual(map.layer(0)), 1e-12);
}

/// Plain Gauss-Seidel in any order of the units ends where the solver ends.
TEST(PolarSolver, EquilibriumDoesNotDependOnTheOrderOfUpdates) {
  const PolarLayout layout({.rings = 20, .sectors = 16, .scope = 1.0});
  const auto weights = ring_weights(layout, PolarWeights::finite_volume, 8);
  const int n = layout.rings(), m = layout.sectors(), target = n - 1;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Projection map = projected(layout, random_points(seed, 1.0), {0.27});
    PolarSolver solver(layout, weights);
    solver.solve(map.layer(0), target, kExact);
    Stream random(seed, "order");
    std::vector<double> v(static_cast<std::size_t>(n * m));
    for (int update = 0; update < 3000 * n * m; ++update) {
      const int unit = random.below(n * m), r = unit % n, s = unit / n;
      const auto at = [&](int ring, int sector) {
        return ring < 0 || ring >= n ? 0.0 : v[static_cast<std::size_t>(layout.wrapped(sector) * n + ring)];
      };
      const RingWeights& w = weights[static_cast<std::size_t>(r)];
      double& value = v[static_cast<std::size_t>(unit)];
      if (unit == target)
        value = 1;
      else if (!map.layer(0).test(r, s))
        value =
            (w.inward * at(r - 1, s) + w.outward * at(r + 1, s) + w.lateral * (at(r, s - 1) + at(r, s + 1))) / w.total;
    }
    for (int s = 0; s < m; ++s)
      for (int r = 0; r < n; ++r)
        ASSERT_NEAR(v[static_cast<std::size_t>(s * n + r)], solver.activation(r, s),
                    1e-10 * solver.activation(r, s) + 1e-300);
  }
}

TEST(PolarSolver, OnlyTheTargetIsALocalMaximum) {
  const PolarLayout layout({});
  PolarSolver solver(layout, ring_weights(layout, PolarWeights::finite_volume, 20));
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Projection map = projected(layout, random_points(seed));
    const int target = seed % 3 == 0 ? 40 : layout.rings() - 1;
    solver.solve(map.layer(0), target, kExact);
    for (int s = 0; s < layout.sectors(); ++s)
      for (int r = 0; r < layout.rings(); ++r) {
        const double v = solver.activation(r, s);
        if (v <= 0 || (s == 0 && r == target)) continue;
        double most =
            std::max(solver.activation(r, layout.wrapped(s - 1)), solver.activation(r, layout.wrapped(s + 1)));
        if (r > 0) most = std::max(most, solver.activation(r - 1, s));
        if (r + 1 < layout.rings()) most = std::max(most, solver.activation(r + 1, s));
        ASSERT_LT(v, most) << "seed " << seed << " ring " << r << " sector " << s;
      }
  }
}

TEST(PolarSolver, MirroredObstaclesMirrorTheActivation) {
  const PolarLayout layout({});
  PolarSolver left(layout, ring_weights(layout, PolarWeights::finite_volume, 20)), right = left;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    ObstructedUnits here(layout), mirrored(layout);
    Stream random(seed, "mirror");
    for (int k = 0; k < 60; ++k) {
      const int sector = random.below(48), first = 1 + random.below(98), last = first + random.below(20);
      here.obstruct(sector, first, last);
      mirrored.obstruct(layout.wrapped(-sector), first, last);
    }
    left.solve(here, 99);
    right.solve(mirrored, 99);
    for (int s = 0; s < 48; ++s)
      for (int r = 0; r < 100; ++r) {
        const double v = left.activation(r, s);
        ASSERT_NEAR(v, right.activation(r, layout.wrapped(-s)), 1e-12 * v);
      }
  }
}

/// The direction read off is the first step of the shortest way over the same grid.
TEST(PolarSubgoalReadout, PointsAlongTheShortestWay) {
  const PolarLayout layout({});
  PolarSolver solver(layout, ring_weights(layout, PolarWeights::finite_volume, 30));
  const SubgoalReadout readout({}, 30);
  int maps = 0, agree = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Projection map = projected(layout, random_points(seed));
    solver.solve(map.layer(0), 99);
    const auto subgoal = readout({layout, solver, {3, 0}, 99, std::nullopt});
    const auto ways = geodesics(layout, map.layer(0), 99);
    if (!subgoal) {
      EXPECT_GT(ways[0], 1e8) << seed;
      continue;
    }
    const int ring = layout.nearest_ring(0.2);
    const auto way = [&](int s) { return ways[static_cast<std::size_t>(layout.wrapped(s) * 100 + ring)]; };
    double shortest = 1e9;
    for (int s = 0; s < 48; ++s) shortest = std::min(shortest, way(s));
    bool near = false;
    for (int s = -1; s <= 1; ++s) near = near || way(subgoal->sector + s) <= shortest * (1 + 1e-9);
    ++maps;
    agree += near;
  }
  EXPECT_GT(maps, 250);
  EXPECT_GE(agree, 0.9 * maps) << agree << " of " << maps;
}

TEST(PolarWeights, LiteralOnesAreAsStableAsThePaperWants) {
  const PolarLayout layout({.rings = 100, .sectors = 32});
  const auto weights = ring_weights(layout, PolarWeights::euclidean, 20);
  EXPECT_NEAR(largest_eigenvalue(weights), 12.2, 0.5);
  EXPECT_GT(weights[1].total, largest_eigenvalue(weights));
  // The condition does not bound a row's gain: why activation piles up at ring 1.
  const RingWeights& w = weights[1];
  EXPECT_GT((w.inward + w.outward + 2 * (w.lateral + w.inward_diagonal + w.outward_diagonal)) / w.total, 1.1);
}

TEST(PolarWeights, OwnOnesWithoutAStableEquilibriumAreRefused) {
  const PolarLayout layout({});
  const auto gain = [&](double total) {
    return [total](const PolarLayout&, int) {
      return RingWeights{.inward = 1, .outward = 1, .lateral = 1, .total = total};
    };
  };
  EXPECT_NO_THROW(ring_weights(layout, gain(4.2)));
  EXPECT_THROW(ring_weights(layout, gain(3.0)), ArgumentError);
  EXPECT_THROW(ring_weights(layout, gain(-1)), ArgumentError);
}

}  // namespace
}  // namespace meander

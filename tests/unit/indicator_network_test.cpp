// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "indicator/dijkstra.hpp"
#include "indicator/hopfield_path.hpp"
#include "indicator/indicator_storage.hpp"
#include "indicator/path_network.hpp"

namespace meander {
namespace {

using Edge = RouteLinks::Edge;

/// How many random graphs: all of them with MEANDER_GRAPHS=10000.
int graphs() {
  const char* wanted = std::getenv("MEANDER_GRAPHS");
  return wanted ? std::atoi(wanted) : 2000;
}

/// Sparse or dense, connected or not; lengths with ties, parallel links, links of an indicator with itself.
std::vector<Edge> random_edges(Stream& random, int n) {
  const int count = static_cast<int>(n * random.uniform(0.5, 3));
  const bool ties = random.chance(0.4);
  const bool long_ways = random.chance(0.3);
  const int near = 1 + random.below(4);
  std::vector<Edge> edges;
  for (int i = 0; i < count; ++i) {
    const int a = random.below(n);
    // Mostly near neighbours, so that routes have many links.
    const int b = random.chance(long_ways ? 1 : 0.8) ? std::clamp(a + random.below(2 * near + 1) - near, 0, n - 1)
                                                     : random.below(n);
    edges.push_back({a, b, ties ? 1 + random.below(3) : random.uniform(0.5, 10)});
    if (random.chance(0.05)) edges.push_back({b, a, edges.back().length * (random.chance(0.5) ? 1 : 1.5)});
  }
  return edges;
}

double length_of(const RouteLinks& links, const Route& route) {
  double sum = 0;
  for (std::size_t i = 1; i < route.indicators.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (const RouteLinks::Way& way : links.ways(route.indicators[i - 1]))
      if (way.to == route.indicators[i]) least = std::min(least, way.length);
    sum += least;
  }
  return sum;
}

/// n indicators in a row, 1 m apart.
RouteLinks chain(int n) {
  std::vector<Edge> edges;
  for (int i = 1; i < n; ++i) edges.push_back({i - 1, i, 1});
  return RouteLinks(n, edges);
}

TEST(PathNetwork, EqualsDijkstraOnRandomGraphs) {
  PathNetwork network;
  int without = 0, truncated = 0;
  for (int seed = 1; seed <= graphs(); ++seed) {
    Stream random(static_cast<std::uint64_t>(seed), "graph");
    const int n = 2 + random.below(random.chance(0.1) ? 1999 : 199);
    const RouteLinks links(n, random_edges(random, n));
    const int start = random.below(n), goal = random.below(n);
    const std::optional<Route> oracle = dijkstra_path(links, start, goal);
    network.excite(links, start, goal, NetworkRows::adaptive);
    EXPECT_FALSE(network.truncated());
    const auto best = network.selected();
    ASSERT_EQ(best.has_value(), oracle.has_value()) << "seed " << seed;
    without += !oracle;
    if (best) {
      const Route route = network.decrypt(*best);
      ASSERT_NEAR(route.length, oracle->length, 1e-6) << "seed " << seed;
      ASSERT_NEAR(length_of(links, route), route.length, 1e-6);
      ASSERT_EQ(route.indicators.front(), start);
      ASSERT_EQ(route.indicators.back(), goal);
      ASSERT_EQ(std::set<int>(route.indicators.begin(), route.indicators.end()).size(), route.indicators.size());
      ASSERT_EQ(static_cast<int>(route.indicators.size()), best->rows);
    }
    network.excite(links, start, std::nullopt, NetworkRows::adaptive);
    ASSERT_LE(network.rows(), n);
    const std::vector<double> distances = dijkstra_distances(links, start);
    for (std::size_t i = 0; i < distances.size(); ++i)
      if (std::isfinite(distances[i])) {
        ASSERT_NEAR(network.potentials()[i], distances[i], 1e-6);
      } else {
        ASSERT_EQ(network.potentials()[i], distances[i]);
      }
    // With the paper's rows: as good, or it says that rows were missing.
    network.excite(links, start, goal, NetworkRows::paper);
    ASSERT_LE(network.rows(), PathNetwork::paper_rows(n));
    const auto short_of = network.selected();
    const bool worse = oracle && (!short_of || short_of->length > oracle->length + 1e-6);
    EXPECT_TRUE(!worse || network.truncated()) << "seed " << seed;
    truncated += worse;
  }
  EXPECT_GT(without, graphs() / 50);
  EXPECT_GT(truncated, 0);
}

TEST(PathNetwork, TheOrderOfLinksChangesNothing) {
  for (int seed = 1; seed <= 60; ++seed) {
    Stream random(static_cast<std::uint64_t>(seed), "order");
    const int n = 5 + random.below(60);
    std::vector<Edge> edges = random_edges(random, n);
    const auto once = neural_shortest_path(RouteLinks(n, edges), 0, n - 1);
    for (std::size_t i = edges.size(); i > 1; --i)
      std::swap(edges[i - 1], edges[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    const auto again = neural_shortest_path(RouteLinks(n, edges), 0, n - 1);
    ASSERT_EQ(once.has_value(), again.has_value());
    if (!once) continue;
    EXPECT_EQ(once->indicators, again->indicators);
  }
}

TEST(PathNetwork, RowsOfThePaperAreTooFewForLongCorridors) {
  EXPECT_EQ(PathNetwork::paper_rows(1), 1);
  EXPECT_EQ(PathNetwork::paper_rows(2), 2);
  EXPECT_EQ(PathNetwork::paper_rows(5), 5);
  EXPECT_EQ(PathNetwork::paper_rows(100), 21);
  PathNetwork network;
  network.excite(chain(100), 0, 20, NetworkRows::paper);
  ASSERT_TRUE(network.selected());
  EXPECT_EQ(network.decrypt(*network.selected()).indicators.size(), 21u);
  EXPECT_TRUE(network.truncated() || network.rows() == 21);
  network.excite(chain(100), 0, 21, NetworkRows::paper);
  EXPECT_FALSE(network.selected());
  EXPECT_TRUE(network.truncated());
  network.excite(chain(100), 0, 99, NetworkRows::adaptive);
  EXPECT_FALSE(network.truncated());
  EXPECT_EQ(network.selected()->rows, 100);
}

TEST(PathNetwork, LayersOfferAndTheFirstSelects) {
  // Direct 10 m; over one indicator 6 m; over two 6 m as well: the fewer rows win.
  const std::vector<Edge> edges = {{0, 3, 10}, {0, 1, 3}, {1, 3, 3}, {1, 2, 1}, {2, 3, 2}};
  PathNetwork network;
  network.excite(RouteLinks(4, edges), 0, 3, NetworkRows::adaptive);
  ASSERT_EQ(network.candidates().size(), 2u);
  EXPECT_EQ(network.candidates()[0].rows, 2);
  EXPECT_EQ(network.candidates()[0].length, 10);
  EXPECT_EQ(network.selected()->rows, 3);
  EXPECT_EQ(network.decrypt(*network.selected()).indicators, (std::vector<int>{0, 1, 3}));
}

TEST(PathNetwork, StartIsGoalAndTiesGoToTheLowerSerialNumber) {
  const auto none = neural_shortest_path(chain(3), 1, 1);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->indicators, std::vector<int>{1});
  EXPECT_EQ(none->length, 0);
  const std::vector<Edge> diamond = {{2, 3, 1}, {0, 2, 1}, {0, 1, 1}, {1, 3, 1}};
  EXPECT_EQ(neural_shortest_path(RouteLinks(4, diamond), 0, 3)->indicators, (std::vector<int>{0, 1, 3}));
}

TEST(PathNetwork, RefusesWhatMakesNoSense) {
  const auto links = [](double length, int a = 0, int b = 1) {
    const Edge edge{a, b, length};
    return RouteLinks(2, std::span(&edge, 1));
  };
  EXPECT_THROW(links(0), ArgumentError);
  EXPECT_THROW(links(-1), ArgumentError);
  EXPECT_THROW(links(std::nan("")), ArgumentError);
  EXPECT_THROW(links(1, 0, 2), ArgumentError);
  PathNetwork network;
  EXPECT_THROW(network.excite(links(1), 2, 0, NetworkRows::adaptive), ArgumentError);
  EXPECT_THROW(network.excite(links(1), 0, -1, NetworkRows::adaptive), ArgumentError);
  EXPECT_THROW(network.excite(RouteLinks(0, {}), 0, 0, NetworkRows::adaptive), ArgumentError);
  EXPECT_THROW(dijkstra_path(links(1), 0, 5), ArgumentError);
}

TEST(HopfieldPath, FindsRoutesOnSmallMapsAndFewOnLongCorridors) {
  const std::vector<Edge> square = {{0, 1, 1}, {1, 3, 1}, {0, 2, 2}, {2, 3, 2}};
  const auto route = hopfield_path(RouteLinks(4, square), 0, 3);
  ASSERT_TRUE(route);
  EXPECT_NEAR(length_of(RouteLinks(4, square), *route), route->length, 1e-9);
  int valid = 0;
  for (int n = 40; n < 50; ++n) valid += hopfield_path(chain(n), 0, PathNetwork::paper_rows(n) - 1).has_value();
  EXPECT_LT(valid, 10);
}

TEST(IndicatorStorage, TheNearestIndicatorIsTheCurrentOne) {
  IndicatorGraph graph;
  const IndicatorId a = graph.place({0, 0}), b = graph.place({2, 0}), c = graph.place({4, 0});
  EXPECT_EQ(winner(graph, {0.3, 0.1}, 1), a);
  EXPECT_EQ(winner(graph, {1, 0}, 2), a);  // a tie
  EXPECT_EQ(winner(graph, {1, 0.1}, 0.5), std::nullopt);
  const int out = graph.add_port(a, 0, 1), back = graph.add_port(b, kPi, 1);
  const int round = graph.add_port(a, 1, 1), round_back = graph.add_port(b, 2, 1);
  graph.link({a, round}, {b, round_back}, 5);
  graph.link({a, out}, {b, back}, 2);
  EXPECT_EQ(way_out(graph, a, b), (PortRef{a, out}));
  EXPECT_EQ(way_out(graph, b, a), (PortRef{b, back}));
  EXPECT_EQ(way_out(graph, a, c), std::nullopt);
  EXPECT_EQ(motion_direction(graph, {b, back}, a), kPi);
  EXPECT_EQ(next_on_route({{4, 1, 7}, 3}, 1), 7);
  EXPECT_EQ(next_on_route({{4, 1, 7}, 3}, 7), std::nullopt);
}

/// Each indicator of the rim is a little nearer by way of the one before it: all fire again in every row.
std::vector<Edge> wheel(int n) {
  std::vector<Edge> edges;
  for (int i = 1; i < n; ++i) edges.push_back({0, i, 2.0 * (i + 1)});
  for (int i = 1; i + 1 < n; ++i) edges.push_back({i, i + 1, 1});
  return edges;
}

TEST(PathNetwork, WhatFiresBySquaresIsToldAndCanBeStopped) {
  PathNetwork network;
  EXPECT_THROW(network.excite(RouteLinks(4000, wheel(4000)), 0, std::nullopt, NetworkRows::adaptive), Error);
  network.excite(RouteLinks(400, wheel(400)), 0, std::nullopt, NetworkRows::adaptive);
  StopToken stop;
  stop.request();
  EXPECT_THROW(network.excite(RouteLinks(400, wheel(400)), 0, std::nullopt, NetworkRows::adaptive, Work{&stop, {}}),
               Cancelled);
}

}  // namespace
}  // namespace meander

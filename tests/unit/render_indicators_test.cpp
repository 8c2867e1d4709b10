// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/angle.hpp"
#include "render/draw_indicators.hpp"

namespace meander {
namespace {

long count(const DrawList& list, Mark mark) {
  return std::count_if(list.items.begin(), list.items.end(),
                       [&](const DrawItem& item) { return mark_of(item) == mark; });
}

TEST(DrawIndicators, ShowsLinksIndicatorsAndOpenEnds) {
  IndicatorGraph graph;
  const IndicatorId a = graph.place({0, 0}), b = graph.place({3, 0});
  graph.link({a, graph.add_port(a, 0, 1)}, {b, graph.add_port(b, kPi, 1)}, 3);
  graph.link({a}, {b}, 3);
  graph.add_port(b, 0, 1);
  graph.block({b, graph.add_port(b, 1, 1)});
  const DrawList list = draw_indicators(graph);
  EXPECT_EQ(count(list, Mark::path), 2);
  EXPECT_EQ(count(list, Mark::start), 2);
  EXPECT_EQ(count(list, Mark::goal), 2);  // their numbers
  EXPECT_EQ(count(list, Mark::echo), 2);
  EXPECT_TRUE(list.view.contains(graph.get(b).position));
  for (const DrawItem& item : list.items) EXPECT_TRUE(drawable(item));
}

TEST(DrawIndicators, ALinkBySightThatTwoOthersLeadAlongIsNotDrawn) {
  IndicatorGraph graph;
  const IndicatorId a = graph.place({0, 0}), b = graph.place({1, 0}), c = graph.place({2, 0}), d = graph.place({1, 1});
  graph.link({a}, {b}, 1);
  graph.link({b}, {c}, 1);
  const int along = graph.link({a}, {c}, 2);
  EXPECT_EQ(count(draw_indicators(graph), Mark::path), 2);
  graph.unlink(along);
  graph.link({a, graph.add_port(a, 0, 1)}, {c, graph.add_port(c, kPi, 1)}, 2);  // driven: it shows
  EXPECT_EQ(count(draw_indicators(graph), Mark::path), 3);
  graph.link({a}, {d}, 1.4);
  graph.link({d}, {b}, 1);  // a triangle shows
  EXPECT_EQ(count(draw_indicators(graph), Mark::path), 5);
}

TEST(DrawIndicators, AnEmptyGraphHasAPicture) { EXPECT_FALSE(draw_indicators(IndicatorGraph()).items.empty()); }

}  // namespace
}  // namespace meander

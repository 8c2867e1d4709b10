// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/layers.hpp"
#include "render/live_picture.hpp"
#include "render/screen.hpp"
#include "render/svg.hpp"

namespace meander {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Plot, TicksAreRoundAndWithinTheRange) {
  EXPECT_EQ(round_ticks(0, 1), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
  EXPECT_EQ(round_ticks(1, 54), (std::vector<double>{10, 20, 30, 40, 50}));
  for (const auto& [low, high] : {std::pair{-3.7, 12.1}, {1e-7, 3e-7}, {-1e9, 1e9}, {99.5, 100.5}}) {
    const auto ticks = round_ticks(low, high);
    EXPECT_GE(ticks.size(), 2u);
    EXPECT_LE(ticks.size(), 12u);
    EXPECT_GE(ticks.front(), low - 1e-9);
    EXPECT_LE(ticks.back(), high + 1e-9 * std::abs(high));
  }
}

std::string ascii(const DrawList& list) { return text(terminal_frame(list, {60, 16}, TerminalMode::ascii)); }

TEST(Plot, ACurveShowsItsTicksAndItsWords) {
  const std::string picture = ascii(draw_curve(std::vector<double>{0, 1, 4, 9, 16, 25}, {"squares", "i", "i * i"}));
  for (const char* word : {"squares", "i * i", "20", "10", "*"})
    EXPECT_NE(picture.find(word), std::string::npos) << picture;
}

TEST(Plot, GapsAndConstantsAndLongCurvesAreDrawn) {
  EXPECT_NE(ascii(draw_curve(std::vector<double>{1, kNan, 2})).find('*'), std::string::npos);
  EXPECT_NE(ascii(draw_curve(std::vector<double>(5, 3.0))).find("**"), std::string::npos);
  std::vector<double> many(100'000);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = std::sin(0.001 * static_cast<double>(i));
  EXPECT_LT(svg(draw_curve(many)).size(), 20'000u);
  EXPECT_THROW(draw_curve(std::vector<double>{kNan}), ArgumentError);
  EXPECT_THROW(draw_curve({}), ArgumentError);
}

TEST(Plot, AHistogramCountsEveryFiniteNumberOnce) {
  const std::vector<double> values{0, 0.1, 0.2, 1, 1.9, 2, kNan};
  const DrawList list = draw_histogram(values, 2);
  std::vector<double> heights;
  for (const DrawItem& item : list.items)
    if (mark_of(item) == Mark::bar) heights.push_back(std::get<DrawArea>(item).polygon.outer[2].y());
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_DOUBLE_EQ(heights[0], heights[1]);
  EXPECT_NE(ascii(list).find("###"), std::string::npos);
  EXPECT_NO_THROW(draw_histogram(std::vector<double>(3, 7.0)));
}

TEST(Plot, NumbersTooLargeToDrawAreGaps) {
  EXPECT_NE(ascii(draw_curve(std::vector<double>{-1.5e308, 1, 2, 1.5e308})).find('*'), std::string::npos);
  EXPECT_NE(ascii(draw_histogram(std::vector<double>{-1.5e308, 1, 2, 1.5e308})).find('#'), std::string::npos);
  EXPECT_THROW(draw_curve(std::vector<double>{-1.5e308, 1.5e308}), ArgumentError);
}

TEST(Plot, ALongMatrixIsDrawnToItsEnd) {
  std::vector<float> values(6'000'000);
  for (std::size_t i = values.size() / 2; i < values.size(); ++i) values[i] = 1;
  for (const bool row : {true, false}) {
    const int length = static_cast<int>(values.size());
    const DrawList list = draw_heat_map(values, row ? 1 : length, row ? length : 1);
    const auto& colors = std::get<DrawCells>(list.items.back()).colors;
    const auto dark = std::count(colors.begin(), colors.end(), row ? colors.back() : colors.front());
    EXPECT_EQ(dark, std::ssize(colors) / 2);
  }
}

TEST(Plot, AHeatMapHasItsFirstRowOnTop) {
  const std::vector<float> values{9, 9, 0, 0};
  const DrawList list = draw_heat_map(values, 2, 2);
  const DrawCells* cells = nullptr;
  for (const DrawItem& item : list.items)
    if (const auto* found = std::get_if<DrawCells>(&item)) cells = found;
  ASSERT_TRUE(cells);
  EXPECT_LT(cells->colors.back().r, cells->colors.front().r) << "bottom row first: dark is on top";
  EXPECT_THROW(draw_heat_map(values, 2, 3), ArgumentError);
}

TEST(Layers, HiddenMarksAreLeftOut) {
  const DrawList list = draw_curve(std::vector<double>{1, 2});
  for (const DrawItem& item : without(list, {Mark::label, Mark::curve}).items) {
    EXPECT_NE(mark_of(item), Mark::label);
    EXPECT_NE(mark_of(item), Mark::curve);
  }
}

TEST(Screen, WritesWhatChangedAndLeavesTheTerminalAsItWas) {
  std::vector<std::string> written;
  {
    Screen screen([&](std::string_view bytes) { written.emplace_back(bytes); });
    Frame frame{4, 1, TerminalMode::ascii, std::vector<Glyph>(4)};
    frame.at(0, 0).code = 'a';
    screen.show(frame, "12.3 s\x1b[31m", {20, 3});
    frame.at(2, 0).code = 'b';
    screen.show(frame, "12.4 s", {20, 3});
    screen.show(frame, "12.4 s", {20, 3});
    screen.show(frame, "long line", {4, 3});
  }
  ASSERT_EQ(written.size(), 5u) << "nothing where nothing changed";
  EXPECT_EQ(written[0], "\x1b[?1049h\x1b[?25l");
  EXPECT_EQ(written[1].substr(0, 16), "\x1b[?2026h\x1b[0m\x1b[2J");
  EXPECT_EQ(written[1].find("\x1b[31m"), std::string::npos) << "texts cannot steer the terminal";
  EXPECT_NE(written[2].find("\x1b[1;3Hb"), std::string::npos);
  EXPECT_LT(written[2].size(), 50u);
  EXPECT_NE(written[3].find("long"), std::string::npos);
  EXPECT_EQ(written[3].find("long "), std::string::npos) << "cut at the width";
  EXPECT_EQ(written[4], Screen::kLeave);
}

TEST(LivePicture, TheWayHasALimitAndMomentsLieBetween) {
  Header header;
  header.bounds = {{0, 0}, {6, 6}};
  LivePicture picture(World(header), {RobotLook{}});
  const auto pose = [](int i) { return Pose2{3 + 2 * std::cos(0.02 * i), 3 + 2 * std::sin(0.02 * i), 0.02 * i}; };
  std::size_t after_one = 0;
  for (int i = 0; i < 20'000; ++i) {
    picture.pass(0, pose(i), false);
    if (i == 400) after_one = svg(picture.at({0, {pose(i)}, {}, {}, {}})).size();
  }
  EXPECT_LT(svg(picture.at({0, {pose(0)}, {}, {}, {}})).size(), 3 * after_one) << "circles over circles";
  const Moment from{1, {{0, 0, 3}}, {{0, 0, 3}}, {{1}}, {{{0, 0}, 1}}},
      to{2, {{2, 0, -3}}, {{2, 0, -3}}, {{5}}, {{{0, 4}, 1}}};
  const Moment half = between(from, to, 0.5);
  EXPECT_DOUBLE_EQ(half.time, 1.5);
  EXPECT_DOUBLE_EQ(half.poses[0].x, 1);
  EXPECT_NEAR(std::abs(half.poses[0].heading), kPi, 1e-9) << "the short way around";
  EXPECT_DOUBLE_EQ(half.scanned_from[0].x, 0);
  EXPECT_DOUBLE_EQ(half.movers[0].center.y(), 2);
}

}  // namespace
}  // namespace meander

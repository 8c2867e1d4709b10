// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/terminal.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/random.hpp"
#include "render/draw_cells.hpp"

namespace meander {
namespace {

constexpr Color kBlack{0, 0, 0};
constexpr Color kRed{255, 0, 0};

DrawArea box(const Vec2& low, const Vec2& high, Mark mark = Mark::wall, Color color = kBlack) {
  return {{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}, color, mark};
}

DrawList view(double width, double height) {
  DrawList list;
  list.view = {{0, 0}, {width, height}};
  return list;
}

std::string ascii(const DrawList& list, int columns, int rows) {
  return text(terminal_frame(list, {columns, rows}, TerminalMode::ascii));
}

TEST(Terminal, ASmallWorldInAsciiIsThis) {
  DrawList list = view(20, 20);
  list.items.emplace_back(box({0, 0}, {20, 0.3}));
  list.items.emplace_back(box({0, 19.7}, {20, 20}));
  list.items.emplace_back(box({0, 0}, {0.3, 20}));
  list.items.emplace_back(box({19.7, 0}, {20, 20}));
  list.items.emplace_back(box({10, 0}, {11, 12}));
  list.items.emplace_back(DrawPolyline{{{4.5, 4}, {4.5, 15}, {15.5, 15}}, false, 0.1, kRed, Mark::path});
  list.items.emplace_back(DrawBody{{{4.5, 4.1}, 1.45}, kPi / 2, kRed, kBlack});
  list.items.emplace_back(DrawDisc{{{15.5, 15}, 1}, kRed, Mark::goal});
  list.items.emplace_back(DrawText{{13, 9}, "lab", 1, kBlack});
  EXPECT_EQ(ascii(list, 20, 10),
            "####################\n"
            "#                  #\n"
            "#   ..........GGG  #\n"
            "#   .              #\n"
            "#   .     #        #\n"
            "#   .     #  lab   #\n"
            "#   .     #        #\n"
            "#  @^@    #        #\n"
            "#  @@@    #        #\n"
            "####################\n");
  EXPECT_EQ(legend(list), "# wall   . path   G goal   @ robot");
}

TEST(Terminal, ColourCellsHoldTwoPixels) {
  DrawList list = view(4, 4);
  list.items.emplace_back(box({0, 3}, {4, 4}, Mark::wall, kRed));
  list.items.emplace_back(box({0, 0}, {1, 2}, Mark::wall, kBlack));
  const Frame frame = terminal_frame(list, {4, 2}, TerminalMode::truecolor);
  constexpr Color kWhite{255, 255, 255};
  ASSERT_EQ(frame.columns, 4);
  ASSERT_EQ(frame.rows, 2);
  EXPECT_EQ(frame.at(1, 0), (Glyph{kUpperHalf, kRed, kWhite}));
  EXPECT_EQ(frame.at(0, 1), (Glyph{' ', kBlack, kBlack}));
  EXPECT_EQ(frame.at(2, 1), (Glyph{' ', kWhite, kWhite}));
}

TEST(Terminal, AThinWallIsOneColumnWideWhereverItStands) {
  Stream random(1, "walls");
  for (int round = 0; round < 500; ++round) {
    DrawList list = view(60, 40);
    const double width = random.uniform(0.0001, 0.5);
    const double x = random.uniform(1, 58);
    list.items.emplace_back(box({x, 0}, {x + width, 40}));
    const std::string picture = ascii(list, 60, 20);
    ASSERT_EQ(std::count(picture.begin(), picture.end(), '#'), 20) << x << " " << width << "\n" << picture;
  }
}

TEST(Terminal, AThinWallIsOneRowHighWhereverItStands) {
  Stream random(2, "walls");
  for (int round = 0; round < 500; ++round) {
    DrawList list = view(60, 40);
    const double width = random.uniform(0.0001, 0.9);
    const double y = random.uniform(1, 38);
    list.items.emplace_back(box({0, y}, {60, y + width}));
    const std::string picture = ascii(list, 60, 20);
    ASSERT_EQ(std::count(picture.begin(), picture.end(), '#'), 60) << y << " " << width << "\n" << picture;
  }
}

/// Can one walk from a cell to the rim without crossing a '#', in steps along rows and columns?
bool leaks(const Frame& frame, int column, int row) {
  std::vector<bool> seen(frame.glyphs.size());
  std::vector<std::pair<int, int>> open{{column, row}};
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    if (x < 0 || y < 0 || x >= frame.columns || y >= frame.rows) return true;
    const auto at = static_cast<std::size_t>(y * frame.columns + x);
    if (seen[at] || frame.at(x, y).code == '#') continue;
    seen[at] = true;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) open.emplace_back(x + dx, y + dy);
  }
  return false;
}

TEST(Terminal, ARoomWithThinWallsIsClosed) {
  Stream random(3, "rooms");
  for (int round = 0; round < 500; ++round) {
    DrawList list = view(80, 48);
    const Pose2 room{40, 24, random.uniform(-kPi, kPi)};
    const double half = random.uniform(4, 16);
    DrawPolyline walls{{}, true, random.uniform(0, 0.8), kBlack, Mark::wall};
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
      walls.points.push_back(room * (half * corner));
    list.items.emplace_back(walls);
    const Frame frame = terminal_frame(list, {80, 24}, TerminalMode::ascii);
    ASSERT_FALSE(leaks(frame, 40, 12)) << text(frame);
  }
}

TEST(Terminal, FramesFitTheSizeAndTheView) {
  Stream random(4, "sizes");
  for (int round = 0; round < 300; ++round) {
    const DrawList list = view(random.uniform(0.01, 100), random.uniform(0.01, 100));
    const TerminalSize size{1 + random.below(120), 1 + random.below(60)};
    const Frame frame = terminal_frame(list, size, static_cast<TerminalMode>(random.below(3)));
    ASSERT_LE(frame.columns, size.columns);
    ASSERT_LE(frame.rows, size.rows);
    ASSERT_TRUE(frame.columns == size.columns || frame.rows == size.rows);
    ASSERT_EQ(frame.glyphs.size(), static_cast<std::size_t>(frame.columns * frame.rows));
  }
}

TEST(Terminal, HeadingsAreCharacters) {
  const auto sign = [](double heading, TerminalMode mode) {
    DrawList list = view(9, 9);
    list.items.emplace_back(DrawBody{{{4.5, 4.5}, 1}, heading, kRed, kBlack});
    const Frame frame = terminal_frame(list, {9, 5}, mode);
    for (const Glyph& glyph : frame.glyphs)
      if (glyph.code != ' ' && glyph.code != '@' && glyph.code != kUpperHalf) return glyph.code;
    return U' ';
  };
  const char32_t arrows[] = {U'→', U'↗', U'↑', U'↖', U'←', U'↙', U'↓', U'↘'};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(sign(i * kPi / 4 + 0.1, TerminalMode::truecolor), arrows[i]);
  const char32_t plain[] = {U'>', U'^', U'<', U'v'};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(sign(i * kPi / 2 - 0.1, TerminalMode::ascii), plain[i]);
  EXPECT_EQ(sign(-kPi, TerminalMode::ascii), U'<');
}

TEST(Terminal, NamesCannotSteerTheTerminal) {
  DrawList list = view(20, 4);
  list.items.emplace_back(DrawText{{1, 3}, "a\x1b[31m\n<&\xff漢", 1, kBlack});
  EXPECT_EQ(ascii(list, 20, 2), " a?[31m?<&??\n\n");
  const std::string colored = text(terminal_frame(list, {20, 2}, TerminalMode::color256));
  EXPECT_EQ(colored.find("[31m\n"), std::string::npos);
  EXPECT_NE(colored.find("a?[31m?<&??"), std::string::npos);
}

TEST(Terminal, ANameOnAWallStandsOnItsHalo) {
  constexpr Color kFloor{250, 250, 250};
  DrawList list = view(8, 4);
  list.items.emplace_back(box({0, 0}, {8, 4}));
  list.items.emplace_back(DrawText{{1, 3}, "lab", 1, kBlack, kFloor});
  const Frame frame = terminal_frame(list, {8, 2}, TerminalMode::truecolor);
  EXPECT_EQ(frame.at(1, 0), (Glyph{U'l', kBlack, kFloor}));
  EXPECT_EQ(frame.at(5, 0), (Glyph{U' ', kBlack, kBlack}));
}

TEST(Terminal, TextsDoNotCoverEachOther) {
  DrawList list = view(20, 4);
  list.items.emplace_back(DrawText{{1, 3}, "first", 1, kBlack});
  list.items.emplace_back(DrawText{{4, 3}, "second", 1, kBlack});
  list.items.emplace_back(DrawText{{7, 3}, "third", 1, kBlack});
  list.items.emplace_back(DrawText{{19, 1}, "right", 1, kBlack, {}, Align::right});
  EXPECT_EQ(ascii(list, 20, 2), " first third\n    second    right\n");
}

TEST(Terminal, NamesMoveOffWallsAndGaps) {
  DrawList list = view(10, 6);
  list.items.emplace_back(box({0, 2}, {4, 4}));
  list.items.emplace_back(box({6, 2}, {10, 4}));
  list.items.emplace_back(DrawText{{5, 3}, "door", 1, kBlack, {}, Align::center});
  EXPECT_EQ(ascii(list, 10, 3), "   door\n####  ####\n\n");
}

TEST(Terminal, LongTextsAreCutAtTheFrame) {
  DrawList list = view(5, 2);
  list.items.emplace_back(DrawText{{1, 1}, "abcdefgh", 1, kBlack});
  EXPECT_EQ(ascii(list, 5, 1), "abcde\n");
}

TEST(Terminal, ImagesShadeByContrast) {
  Image image{4, 2, 1, {255, 255, 0, 0, 255, 255, 0, 0}};
  EXPECT_EQ(ascii(draw_image(image), 4, 1), "  %%\n");
  const Frame frame = terminal_frame(draw_image({1, 2, 3, {1, 2, 3, 4, 5, 6}}), {1, 1}, TerminalMode::truecolor);
  EXPECT_EQ(frame.at(0, 0), (Glyph{kUpperHalf, {1, 2, 3}, {4, 5, 6}}));
  EXPECT_THROW(draw_image({2, 2, 3, {1, 2, 3}}), ArgumentError);
}

TEST(Terminal, EmptyAndNastyListsGiveFrames) {
  EXPECT_EQ(ascii(DrawList{}, 3, 3), "\n\n");
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  DrawList list = view(1, 1);
  list.items.emplace_back(DrawBody{{{0.5, 0.5}, kNan}, 0, kRed, kRed});
  list.items.emplace_back(DrawBody{{{1e11, 0.5}, 1}, 0, kRed, kRed});
  list.items.emplace_back(DrawBody{{{1, 1}, 1e-9}, 0, kRed, kRed});
  list.items.emplace_back(DrawBody{{{0, 0}, 1e-9}, 1e11, kRed, kRed});
  list.items.emplace_back(DrawText{{1e11, kNan}, "x", 1, kRed});
  for (const TerminalMode mode : {TerminalMode::ascii, TerminalMode::color256, TerminalMode::truecolor})
    EXPECT_EQ(terminal_frame(list, {1, 1}, mode).glyphs.size(), 1u);
  EXPECT_THROW(terminal_frame(list, {0, 5}, TerminalMode::ascii), ArgumentError);
  EXPECT_THROW(terminal_frame(list, {80, 100'000}, TerminalMode::ascii), ArgumentError);
}

}  // namespace
}  // namespace meander

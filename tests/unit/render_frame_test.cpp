// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/frame.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "base/random.hpp"
#include "render/unicode.hpp"

namespace meander {
namespace {

/// What a person sees in one cell: two halves of colour, and a character unless it is a block.
struct Seen {
  std::string upper, lower, sign;
  bool operator==(const Seen&) const = default;
};

/// A terminal that knows the sequences a frame may use; anything else fails the test.
class Screen {
 public:
  void feed(const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
      if (bytes[at] == '\x1b') {
        const std::size_t end = bytes.find_first_not_of("0123456789;?", at + 2);
        ASSERT_TRUE(bytes.substr(at, 2) == "\x1b[" && end != std::string::npos) << "unknown sequence";
        control(bytes.substr(at + 2, end - at - 2), bytes[end]);
        at = end + 1;
      } else if (bytes[at] == '\n') {
        ++row_, column_ = 1, ++at;
      } else {
        const char32_t code = code_points(bytes.substr(at, 4)).front();
        std::string sign;
        append_utf8(sign, code);
        at += sign.size();
        show(code, sign);
      }
    }
  }
  std::map<std::pair<int, int>, Seen> cells;  ///< by row and column, from 1

 private:
  void control(const std::string& numbers, char kind) {
    if (numbers == "?2026") return;
    std::vector<std::string> parts;
    std::istringstream stream(numbers);
    for (std::string part; std::getline(stream, part, ';');) parts.push_back(part);
    if (kind == 'H') {
      row_ = std::stoi(parts.at(0)), column_ = std::stoi(parts.at(1));
    } else if (kind == 'C') {
      column_ += std::stoi(parts.at(0));
    } else if (kind == 'm') {
      color(parts);
    } else {
      FAIL() << kind;
    }
  }
  void color(const std::vector<std::string>& parts) {
    if (parts.at(0) == "0") ink_ = paper_ = "";
    for (std::size_t i = 0; i + 1 < parts.size();) {
      const std::size_t count = parts[i + 1] == "5" ? 3 : 5;
      std::string value;
      for (std::size_t k = 2; k < count; ++k) value += parts.at(i + k) + ".";
      (parts[i] == "38" ? ink_ : paper_) = value;
      i += count;
    }
  }
  void show(char32_t code, const std::string& sign) {
    Seen seen{paper_, paper_, sign == " " ? "" : sign};
    if (code == kUpperHalf) seen = {ink_, paper_, ""};
    if (code == kLowerHalf) seen = {paper_, ink_, ""};
    if (!seen.sign.empty()) seen.sign += ink_;
    cells[{row_, column_++}] = seen;
  }
  int row_ = 1, column_ = 1;
  std::string ink_, paper_;
};

Frame random_frame(Stream& random, TerminalMode mode) {
  const auto color = [&] {
    const auto level = [&] { return static_cast<std::uint8_t>(random.below(3) * 100); };
    return Color{level(), level(), level()};
  };
  Frame frame{7, 4, mode, std::vector<Glyph>(28)};
  constexpr char32_t kSigns[] = {' ', kUpperHalf, kUpperHalf, 'a', U'é'};
  for (Glyph& glyph : frame.glyphs) {
    if (mode == TerminalMode::ascii)
      glyph.code = static_cast<char32_t>(" #.@"[random.below(4)]);
    else
      glyph = {kSigns[random.below(5)], color(), color()};
  }
  return frame;
}

class EveryMode : public testing::TestWithParam<TerminalMode> {};
INSTANTIATE_TEST_SUITE_P(Frame, EveryMode,
                         testing::Values(TerminalMode::ascii, TerminalMode::color256, TerminalMode::truecolor),
                         [](const auto& which) { return std::string(to_string(which.param)); });

TEST_P(EveryMode, ADifferenceTurnsOneFrameIntoTheOther) {
  Stream random(1, "frames");
  Frame shown = random_frame(random, GetParam());
  Screen screen;
  screen.feed(frame_difference({}, shown));
  for (int round = 0; round < 300; ++round) {
    Frame next = shown;
    const Frame other = random_frame(random, GetParam());
    for (std::size_t i = 0; i < next.glyphs.size(); ++i)
      if (random.chance(0.02 * (round % 50))) next.glyphs[i] = other.glyphs[i];
    screen.feed(frame_difference(shown, next));
    Screen fresh;
    fresh.feed(frame_difference({}, next));
    ASSERT_EQ(screen.cells, fresh.cells);
    shown = next;
  }
}

TEST_P(EveryMode, TextAndDifferenceShowTheSame) {
  Stream random(2, "frames");
  for (int round = 0; round < 100; ++round) {
    const Frame frame = random_frame(random, GetParam());
    Screen lines, painted;
    lines.feed(text(frame));
    painted.feed(frame_difference({}, frame));
    for (const auto& [at, seen] : painted.cells)
      ASSERT_EQ(lines.cells[at], seen);  // a blank that was not written looks like one that was
  }
}

TEST_P(EveryMode, NothingChangedCostsNothing) {
  Stream random(3, "frames");
  const Frame frame = random_frame(random, GetParam());
  EXPECT_EQ(frame_difference(frame, frame), "");
}

TEST(Frame, PlainTextHasNoEscapesAndNoTrailingBlanks) {
  Frame frame{3, 2, TerminalMode::ascii, std::vector<Glyph>(6)};
  frame.at(1, 0).code = '#';
  EXPECT_EQ(text(frame), " #\n\n");
  EXPECT_EQ(text(Frame{}), "");
}

TEST(Frame, ColoursAreSetOnlyWhereTheyChange) {
  constexpr Color kInk{1, 2, 3}, kPaper{9, 8, 7};
  Frame frame{
      3, 1, TerminalMode::truecolor, {{kUpperHalf, kInk, kPaper}, {kUpperHalf, kPaper, kInk}, {' ', kPaper, kPaper}}};
  EXPECT_EQ(text(frame), "\x1b[38;2;1;2;3;48;2;9;8;7m\u2580\u2584 \x1b[0m\n");
}

TEST(Frame, AChangeMovesTheCursorThere) {
  Frame before{9, 3, TerminalMode::ascii, std::vector<Glyph>(27)};
  Frame after = before;
  after.at(4, 1).code = '@', after.at(5, 1).code = '#', after.at(8, 1).code = '.';
  EXPECT_EQ(frame_difference(before, after, 3, 10), "\x1b[?2026h\x1b[11;7H@#\x1b[2C.\x1b[?2026l");
}

TEST(Frame, ColoursBecomeTheNearestOfXterms256) {
  const auto code = [](Color color) {
    const std::string line = text({1, 1, TerminalMode::color256, {{' ', color, color}}});
    return std::stoi(line.substr(line.rfind("5;") + 2));
  };
  EXPECT_EQ(code({0, 0, 0}), 16);
  EXPECT_EQ(code({255, 255, 255}), 231);
  EXPECT_EQ(code({255, 0, 0}), 196);
  EXPECT_EQ(code({118, 118, 118}), 243);
  EXPECT_EQ(code({95, 135, 175}), 67);
}

}  // namespace
}  // namespace meander

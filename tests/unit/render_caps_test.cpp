// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/terminal_caps.hpp"

#include <gtest/gtest.h>

namespace meander {
namespace {

constexpr TerminalMode kAscii = TerminalMode::ascii;
constexpr TerminalMode k256 = TerminalMode::color256;
constexpr TerminalMode kTrue = TerminalMode::truecolor;

TEST(TerminalMode, FollowsTheEnvironment) {
  struct Case {
    TerminalEnvironment environment;
    TerminalMode mode;
  };
  //                     terminal  TERM              COLORTERM    NO_COLOR FORCE MEANDER_GRAPHICS
  const Case cases[] = {
      {{true, "xterm-256color", "truecolor", "", "", ""}, kTrue},
      {{true, "xterm-256color", "24bit", "", "", ""}, kTrue},
      {{true, "xterm-256color", "", "", "", ""}, k256},
      {{true, "xterm-direct", "", "", "", ""}, kTrue},
      {{true, "xterm", "yes", "", "", ""}, k256},
      {{true, "dumb", "truecolor", "", "", ""}, kAscii},
      {{true, "", "", "", "", ""}, kAscii},
      {{false, "xterm-256color", "truecolor", "", "", ""}, kAscii},
      {{true, "xterm-256color", "truecolor", "1", "", ""}, kAscii},
      {{true, "xterm-256color", "truecolor", "1", "1", ""}, kAscii},
      {{false, "xterm-256color", "truecolor", "", "1", ""}, kTrue},
      {{false, "dumb", "", "", "1", ""}, k256},
      {{false, "xterm", "truecolor", "", "0", ""}, kAscii},
      {{true, "xterm", "truecolor", "", "", "ascii"}, kAscii},
      {{false, "dumb", "", "1", "", "truecolor"}, kTrue},
      {{false, "xterm", "", "1", "", "half"}, k256},
      {{false, "xterm", "truecolor", "", "", "half"}, kTrue},
      {{true, "xterm", "truecolor", "", "", "color256"}, k256},
      {{true, "xterm", "truecolor", "", "", "kitty"}, kTrue},
      {{true, "xterm", "", "", "", "sixel"}, k256},
      {{true, "xterm", "truecolor", "", "", "none"}, kAscii},
  };
  for (const Case& c : cases)
    EXPECT_EQ(terminal_mode(c.environment), c.mode)
        << c.environment.term << " " << c.environment.colorterm << " " << c.environment.graphics;
}

TEST(TerminalMode, AnUnknownWordIsRefusedWithTheNearest) {
  try {
    terminal_mode({true, "xterm", "", "", "", "asci"});
    FAIL();
  } catch (const ArgumentError& error) {
    EXPECT_STREQ(error.what(),
                 "MEANDER_GRAPHICS: one of ascii, color256, truecolor, half, sixel, kitty, none expected, got 'asci'; "
                 "did you mean 'ascii'?");
  }
}

TEST(StillMode, AsksOnlyTerminalsThatCanAnswer) {
  const auto mode = [](const TerminalEnvironment& environment) { return still_mode(environment); };
  EXPECT_FALSE(mode({true, "xterm-256color", "", "", "", ""}));
  EXPECT_EQ(mode({true, "xterm-256color", "", "", "", "", true}), StillMode::characters);
  EXPECT_EQ(mode({true, "tmux-256color", "", "", "", ""}), StillMode::characters);
  EXPECT_EQ(mode({true, "screen", "", "", "", ""}), StillMode::characters);
  EXPECT_EQ(mode({true, "linux", "", "", "", ""}), StillMode::characters);
  EXPECT_EQ(mode({true, "dumb", "", "", "", ""}), StillMode::characters);
  EXPECT_EQ(mode({true, "xterm", "", "1", "", ""}), StillMode::characters);
  EXPECT_EQ(mode({false, "xterm", "", "", "1", ""}), StillMode::characters);
  EXPECT_EQ(mode({true, "xterm", "", "", "", "half"}), StillMode::characters);
  EXPECT_EQ(mode({false, "dumb", "", "1", "", "kitty"}), StillMode::kitty);
  EXPECT_EQ(mode({false, "dumb", "", "", "", "sixel"}), StillMode::sixel);
  EXPECT_EQ(mode({true, "xterm", "", "", "", "none"}), StillMode::none);
}

TEST(GraphicsAnswer, TellsAnswersFromKeys) {
  const auto kitty = read_graphics_answer("\x1b_Gi=31;OK\x1b\\\x1b[?62;c");
  EXPECT_TRUE(kitty.complete);
  EXPECT_EQ(kitty.still(), StillMode::kitty);
  EXPECT_EQ(read_graphics_answer("\x1b[?62;4;22c").still(), StillMode::sixel);
  EXPECT_EQ(read_graphics_answer("\x1b[?4c").still(), StillMode::sixel);
  EXPECT_EQ(read_graphics_answer("\x1b[?64;14;24;40c").still(), StillMode::characters);
  EXPECT_EQ(read_graphics_answer("\x1b_Gi=31;ENOTSUPPORTED\x1b\\\x1b[?1;2c").still(), StillMode::characters);
  const auto mixed = read_graphics_answer("ab\x1b[A\x1b[?1;4cc\r");
  EXPECT_EQ(mixed.keys, "ab\x1b[Ac\r");
  EXPECT_TRUE(mixed.sixel);
  EXPECT_FALSE(read_graphics_answer("x\x1b[?1;").complete) << "the rest has not come";
  EXPECT_EQ(read_graphics_answer("x\x1b[?1;").keys, "x");
}

}  // namespace
}  // namespace meander

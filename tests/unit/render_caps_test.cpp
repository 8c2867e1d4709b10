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
    EXPECT_STREQ(
        error.what(),
        "MEANDER_GRAPHICS: one of ascii, color256, truecolor, half expected, got 'asci'; did you mean 'ascii'?");
  }
}

}  // namespace
}  // namespace meander

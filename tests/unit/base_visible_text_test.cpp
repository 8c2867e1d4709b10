// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/visible_text.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace meander {
namespace {

TEST(VisibleText, LeavesTextAndItsLines) {
  for (const char* text : {"", "plain", "two\nlines\tand a tab", "äöü € 日本語 🤖"})
    EXPECT_EQ(visible_text(text), text);
}

TEST(VisibleText, WritesControlCharactersAsLuaDoes) {
  EXPECT_EQ(visible_text(std::string_view("a\0b\x1b[2J\x07\x7f\r", 10)), "a\\0b\\27[2J\\7\\127\\13");
  EXPECT_EQ(visible_text("\xc2\x9b"
                         "31m"),
            "\\194\\15531m");
}

TEST(VisibleText, WritesWhatIsNoUtf8AsBytes) {
  EXPECT_EQ(visible_text("\xff\x80 \xc3"), "\\255\\128 \\195");
  EXPECT_EQ(visible_text("\xe2\x82"), "\\226\\130");
  EXPECT_EQ(visible_text("\xe0\x80\xaf"), "\\224\\128\\175");           // longer than needed
  EXPECT_EQ(visible_text("\xed\xa0\x80"), "\\237\\160\\128");           // half of a pair
  EXPECT_EQ(visible_text("\xf4\x90\x80\x80"), "\\244\\144\\128\\128");  // beyond the last one
}

TEST(VisibleText, WritesWhatTurnsTextsRoundOrIsNoCharacterAsBytes) {
  EXPECT_EQ(visible_text("\xe2\x80\xae"), "\\226\\128\\174");  // right to left from here
  EXPECT_EQ(visible_text("\xef\xbf\xbf"), "\\239\\191\\191");  // which XML forbids
  EXPECT_EQ(visible_text("\xef\xbf\xbd"), "\xef\xbf\xbd");
}

// Whatever the bytes: nothing that is left commands a terminal, and what is left is left alone.
TEST(VisibleText, IsAtRestAfterOnce) {
  Stream random(5, "visible_text");
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    for (int k = random.below(12); k >= 0; --k) text += static_cast<char>(random.below(256));
    const std::string shown = visible_text(text);
    EXPECT_EQ(visible_text(shown), shown);
    for (const char c : shown)
      EXPECT_TRUE(c == '\n' || c == '\t' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f));
  }
}

}  // namespace
}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/unicode.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "render/draw_list.hpp"

namespace meander {
namespace {

std::string utf8(const std::u32string& codes) {
  std::string text;
  for (const char32_t code : codes) append_utf8(text, code);
  return text;
}

TEST(Unicode, EveryCodePointSurvives) {
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code >= 0xD800 && code <= 0xDFFF) continue;
    ASSERT_EQ(code_points(utf8({code})), std::u32string(1, code)) << std::hex << static_cast<unsigned>(code);
  }
}

TEST(Unicode, AnyBytesBecomePrintableText) {
  Stream random(1, "bytes");
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    for (int i = random.below(40); i > 0; --i) bytes += static_cast<char>(random.below(256));
    const std::string clean = printable(bytes);
    for (const char32_t code : code_points(clean)) ASSERT_FALSE(is_control(code));
    ASSERT_EQ(utf8(code_points(clean)), clean);
    ASSERT_EQ(printable(clean), clean);
  }
}

TEST(Unicode, BrokenSequencesAreReplacedByteByByte) {
  EXPECT_EQ(code_points("\xC3"), U"\uFFFD");                      // cut short
  EXPECT_EQ(code_points("\xC0\x80"), U"\uFFFD\uFFFD");            // overlong zero
  EXPECT_EQ(code_points("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD");  // surrogate
  EXPECT_EQ(code_points("a\x80z"), U"a\uFFFDz");
}

TEST(Unicode, EscapesAndDirectionOverridesDoNotPass) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a\uFFFD[2Jb");
  EXPECT_EQ(printable("a\nb"), "a\uFFFDb");
  EXPECT_EQ(printable("a\u202Eb"), "a\uFFFDb");
  EXPECT_EQ(printable("a\u009Bb"), "a\uFFFDb");
  EXPECT_EQ(printable("Küche ☕"), "Küche ☕");
}

TEST(Unicode, NarrowMeansOneColumn) {
  for (const char32_t code : U"az~éßжЯλ→█▀│") EXPECT_TRUE(code == 0 || is_narrow(code)) << static_cast<unsigned>(code);
  for (const char32_t code : {U'漢', U'☕', U'\u0301', U'\u00AD', U'\u200D', U'\n', U'\x7F'})
    EXPECT_FALSE(is_narrow(code)) << static_cast<unsigned>(code);
}

}  // namespace
}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/help_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "script/bindings.hpp"
#include "script/wrapped_text.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

TEST(WrappedText, GoesOnBelowTheSecondColumn) {
  EXPECT_EQ(wrapped("  name  one two three four\nshort", 18), "  name  one two\n        three four\nshort");
  EXPECT_EQ(wrapped("  one two three four\n", 12), "  one two\n  three four\n");
  EXPECT_EQ(wrapped("  a_long_name_of_a_thing  one two", 20), "  a_long_name_of_a_thing\n  one two");
  EXPECT_EQ(wrapped("a_word_that_is_too_long for it", 10), "a_word_that_is_too_long\nfor it");
  EXPECT_EQ(wrapped("as it is, however long", 0), "as it is, however long");
  EXPECT_EQ(wrapped("", 10), "");
}

class Help : public ScriptState {
 protected:
  Help() { bind_all(L); }
  std::string of(const char* name, std::size_t width = 0) {
    return help_text(session_.docs, *session_.docs.find(name), width);
  }
};

TEST_F(Help, BreaksLinesButNeitherWordsNorExamples) {
  for (const Record& record : session_.docs.all()) {
    std::string broken = of(record.name().c_str(), 60), whole = of(record.name().c_str());
    const auto without_blanks = [](std::string text) {
      std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
      return text;
    };
    EXPECT_EQ(without_blanks(broken), without_blanks(whole));
    const std::size_t example = whole.find("\n  example\n");
    if (example != std::string::npos) {
      EXPECT_TRUE(broken.ends_with(whole.substr(example)));
    }
  }
}

TEST_F(Help, TellsOptionsOnce) {
  const std::string text = of("sim:drive");
  EXPECT_NE(text.find("; navigator, subgoals, guide"), std::string::npos) << text;
  const std::size_t first = text.find("  guide ");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(text.find("  guide ", first + 1), std::string::npos) << text;
}

}  // namespace
}  // namespace meander::script

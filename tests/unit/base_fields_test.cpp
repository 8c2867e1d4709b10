// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/fields.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace meander {

enum class Mood { calm, wild };
template <>
struct EnumNames<Mood> {
  static constexpr std::pair<Mood, const char*> entries[] = {{Mood::calm, "calm"}, {Mood::wild, "wild"}};
};

struct Inner {
  double share = 0.5;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, Inner>
void fields(Options& o, Visitor&& visit) { visit(Field{"share", "", "a share", 0, 1}, o.share); }

struct Outer {
  double length = 1;
  double any = 0;
  int count = 3;
  bool on = true;
  Mood mood = Mood::calm;
  std::string name = "x";
  Inner inner;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, Outer>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"length", "m", "a length", 0}, o.length);
  visit(Field{"any", "", "any number"}, o.any);
  visit(Field{"count", "", "a count", 1, 9}, o.count);
  visit(Field{"on", "", "a switch"}, o.on);
  visit(Field{"mood", "", "a mood"}, o.mood);
  visit(Field{"name", "", "a name"}, o.name);
  visit(Field{"inner", "", "more"}, o.inner);
}

namespace {

template <class Change>
std::string complaint(Change change, const std::string& where = {}) {
  Outer options;
  change(options);
  try {
    validate(options, where);
  } catch (const ArgumentError& e) {
    return e.what();
  }
  return "";
}

TEST(Fields, DefaultsAreValid) {
  EXPECT_EQ(complaint([](Outer&) {}), "");
}

TEST(Fields, NamesComeInOrder) {
  EXPECT_EQ(field_names<Outer>(), (std::vector<std::string>{"length", "any", "count", "on", "mood", "name", "inner"}));
}

TEST(Fields, RangesAreNamedWithValueAndUnit) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint([](Outer& o) { o.length = -1; }), "option 'length': a number >= 0 [m] expected, got -1");
  EXPECT_EQ(complaint([](Outer& o) { o.count = 10; }), "option 'count': a number from 1 to 9 expected, got 10");
  EXPECT_EQ(complaint([](Outer& o) { o.any = kNan; }), "option 'any': a finite number expected, got nan");
  EXPECT_EQ(complaint([](Outer& o) { o.length = kInfinity; }), "option 'length': a number >= 0 [m] expected, got inf");
  EXPECT_EQ(complaint([](Outer& o) { o.inner.share = 2; }, "a."),
            "option 'a.inner.share': a number from 0 to 1 expected, got 2");
  EXPECT_EQ(complaint([](Outer& o) { o.length = 0, o.count = 9, o.inner.share = 1; }), "");
}

TEST(Fields, EnumerationsHaveNames) {
  EXPECT_STREQ(to_string(Mood::wild), "wild");
  EXPECT_EQ(enum_from<Mood>("calm"), Mood::calm);
  EXPECT_EQ(enum_from<Mood>("cold"), std::nullopt);
  EXPECT_EQ(enum_names<Mood>(), (std::vector<std::string>{"calm", "wild"}));
}

}  // namespace
}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

int living = 0;     ///< robots
int destroyed = 0;  ///< guards

struct Guard {
  ~Guard() { ++destroyed; }
};

enum class Gait { walk, trot };

struct Robot {
  Robot() { ++living; }
  Robot(const Robot& other) : name(other.name), size(other.size), gait(other.gait) { ++living; }
  ~Robot() { --living; }
  std::string name = "anna";
  double size = 0.5;
  Gait gait = Gait::walk;
  Vec2 at{1, 2};
};

struct Legs {
  int count = 4;
  double length = 0.3;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, Legs>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"count", "", "how many", 1, 8}, o.count);
  visit(Field{"length", "m", "of each", 0, 2}, o.length);
}

struct RobotOptionsTable {
  Required<Size> size;
  std::string name;
  Gait gait = Gait::walk;
  Legs legs;
  std::vector<Vec2> route;
  std::optional<Preset<Legs>> spare;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RobotOptionsTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"size", "m", "of the body"}, o.size);
  visit(Field{"name", "", "its name"}, o.name);
  visit(Field{"gait", "", "how it goes"}, o.gait);
  visit(Field{"legs", "", "what it goes on"}, o.legs);
  visit(Field{"route", "m", "where it goes"}, o.route);
  visit(Field{"spare", "", "more legs"}, o.spare);
}

}  // namespace
}  // namespace meander::script

namespace meander {
template <>
struct EnumNames<script::Gait> {
  static constexpr std::pair<script::Gait, const char*> entries[] = {{script::Gait::walk, "walk"},
                                                                     {script::Gait::trot, "trot"}};
};
}  // namespace meander

namespace meander::script {
template <>
struct ObjectName<Robot> {
  static constexpr const char* value = "robot";
};
template <>
struct PresetSource<Legs> {
  static Legs get(const std::string& name) { return name == "short" ? Legs{4, 0.1} : Legs{6, 1.0}; }
  static std::vector<std::string> names() { return {"short", "long"}; }
};

namespace {

std::size_t native_size(const Robot&) { return 1 << 20; }

std::shared_ptr<Robot> make(const RobotOptionsTable& options) {
  auto robot = std::make_shared<Robot>();
  robot->name = options.name.empty() ? "anna" : options.name;
  robot->size = options.size.value.width;
  robot->gait = options.gait;
  return robot;
}
double add(double a, std::optional<int> b) { return a + b.value_or(10); }
std::tuple<double, std::string> pair_of(const std::vector<double>& list) { return {list.at(1), "second"}; }
void grow(Robot& robot, double by) {
  const Guard guard;
  if (by < 0) fail("by: a positive number expected, got {}", by);
  robot.size += by;
}
Robot copy(const Robot& robot) { return robot; }
std::shared_ptr<Robot> same(std::shared_ptr<Robot> robot) { return robot; }
double each(Robot& robot, const Function& visit) {
  const Guard guard;
  visit.call(robot.at);
  return visit.get<double>(Vec2(3, 4)) + robot.size;
}
void spin(const Call& call) {
  const Guard guard;
  for (;;) call.work().poll();
}
void misbehave(const std::string& how) {
  if (how == "memory") throw std::bad_alloc();
  throw std::runtime_error("line 1\nline 2");
}
std::string text(const Robot& robot) { return "robot \"" + robot.name + "\""; }
void set_name(Robot& robot, const std::string& name) { robot.name = name; }
std::optional<double> digit(const Robot&, lua_Integer i) {
  return i >= 1 && i <= 3 ? std::optional(10.0 * static_cast<double>(i)) : std::nullopt;
}
/// A function that the test keeps after the call.
Function kept;
void keep(const Function& f) { kept = f; }
double call_kept() { return kept.get<double>(); }
int run_all(const std::vector<Function>& list) {
  for (const Function& f : list) f.call();
  return static_cast<int>(list.size());
}

void bind(lua_State* L) {
  constexpr auto robot = "r = kit.new { size = {1, 1} }";
  Module(L, "kit", "A module for tests.")
      .function<&make>(Doc{.name = "new",
                           .text = "Makes a robot.",
                           .args = {{"options", "what it is like"}},
                           .returns = "the robot",
                           .example = robot})
      .function<&add>(Doc{.name = "add",
                          .text = "Adds.",
                          .args = {{"a", "first", "m"}, {"b", "second; 10 when left out"}},
                          .returns = "the sum",
                          .example = "kit.add(1, 2)"})
      .function<&pair_of>(Doc{.name = "pair_of",
                              .text = "Second element.",
                              .args = {{"list", "some numbers"}},
                              .returns = "number and text",
                              .example = "kit.pair_of {1, 2}"})
      .function<&spin>(Doc{.name = "spin", .text = "Works until stopped.", .example = "--kit.spin()"})
      .function<&keep>(
          Doc{.name = "keep", .text = "Keeps a function.", .args = {{"f", "it"}}, .example = "kit.keep(print)"})
      .function<&call_kept>(Doc{.name = "call_kept", .text = "Calls it.", .returns = "its result", .example = "--"})
      .function<&run_all>(Doc{.name = "run_all",
                              .text = "Calls all.",
                              .args = {{"list", "functions"}},
                              .returns = "how many",
                              .example = "--"})
      .function<&misbehave>(
          Doc{.name = "misbehave", .text = "Throws.", .args = {{"how", "which way"}}, .example = "--"});
  Type<Robot>(L, "Something for tests.")
      .method<&grow>(
          Doc{.name = "grow", .text = "Makes it larger.", .args = {{"by", "how much", "m"}}, .example = "--"})
      .method<&copy>(Doc{.name = "copy", .text = "Another one.", .returns = "the copy", .example = "--"})
      .method<&same>(Doc{.name = "same", .text = "Itself.", .returns = "itself", .example = "--"})
      .method<&each>(Doc{.name = "each",
                         .text = "Calls back.",
                         .args = {{"visit", "function(point)"}},
                         .returns = "a number",
                         .example = "--"})
      .property<&Robot::size>(PropertyDoc{.name = "size", .text = "Its size.", .unit = "m", .example = "--"})
      .property<&Robot::name, &set_name>(PropertyDoc{.name = "name", .text = "Its name.", .example = "--"})
      .property<&Robot::at>(PropertyDoc{.name = "at", .text = "Its place.", .example = "--"})
      .text<&text>()
      .element<&digit>();
}

class Kit : public ScriptState {
 protected:
  Kit() { bind(L); }
};

static_assert(complete(Doc{.name = "a", .text = "b", .example = "c"}, 0, false));
static_assert(!complete(Doc{.name = "a", .text = "b"}, 0, false), "an example is missing");
static_assert(!complete(Doc{.name = "a", .example = "c"}, 0, false), "the text is missing");
static_assert(!complete(Doc{.name = "a", .text = "b", .example = "c"}, 1, false), "an argument is missing");
static_assert(!complete(Doc{.name = "a", .text = "b", .example = "c"}, 0, true), "the result is missing");
static_assert(!complete(Doc{.name = "a", .text = "b", .args = {{"x", "y"}}, .example = "c"}, 0, false), "one too many");

TEST_F(Kit, ReadsArgumentsAndReturnsResults) {
  EXPECT_EQ(run("return kit.add(1, 2)"), "3.0");
  EXPECT_EQ(run("return kit.add(1)"), "11.0");
  EXPECT_EQ(run("return select('#', kit.pair_of {1, 2.5})"), "2");
  EXPECT_EQ(run("return (select(2, kit.pair_of {1, 2.5}))"), "second");
  EXPECT_EQ(run("r = kit.new { size = {3, 1}, name = 'bob', gait = 'trot' } return r.size, r.name, tostring(r)"),
            "3.0 bob robot \"bob\"");
  EXPECT_EQ(run("r = kit.new { size = {width = 3, height = 1} } r.name = 'eve' r:grow(1) return r.size, r.name"),
            "4.0 eve");
  EXPECT_EQ(run("local p = kit.new { size = {3, 1} }.at return p.x, p[2], tostring(p), p == {1.0, 2.0}, #p"),
            "1.0 2.0 {1, 2} true 2");
  EXPECT_EQ(
      run("local s = '' for i, d in ipairs(kit.new { size = {1, 1} }) do s = s .. i .. '=' .. d .. ' ' end return s"),
      "1=10.0 2=20.0 3=30.0 ");
}

TEST_F(Kit, MessagesSayWhereWhatAndWhatWasExpected) {
  const std::pair<const char*, const char*> cases[] = {
      {"kit.add('abc', 1)", "test:1: kit.add: argument 1 ('a'): number expected, got string \"abc\""},
      {"kit.add()", "test:1: kit.add: argument 1 ('a'): number expected, got nothing"},
      {"kit.add(0/0)", "test:1: kit.add: argument 1 ('a'): finite number expected, got number nan"},
      {"kit.add(1, 1.5)", "test:1: kit.add: argument 2 ('b'): integer expected, got number 1.5"},
      {"kit.add(1, 1 << 40)", "test:1: kit.add: argument 2 ('b'): integer 1099511627776 out of range"},
      {"kit.add(1, 2, 3)", "test:1: kit.add: takes 2 arguments at most, got 3"},
      {"kit.spin(1)", "test:1: kit.spin: takes no arguments, got 1"},
      {"kit:add(1)", "test:1: kit.add: argument 1 ('a'): number expected, got module (call it with '.')"},
      {"kit.adt(1)",
       "test:1: kit: has no member 'adt'; did you mean 'add'? (known: new, add, pair_of, spin, keep, "
       "call_kept, run_all, misbehave)"},
      {"kit.pair_of {1, 'x'}", "test:1: kit.pair_of: argument 1 ('list[2]'): number expected, got string \"x\""},
      {"kit.pair_of {x = 1}", "test:1: kit.pair_of: argument 1 ('list'): list of number expected, got table {x = ...}"},
      {"kit.new { size = 3 }", "test:1: kit.new: option 'size': {width, height} expected, got number 3"},
      {"kit.new { size = {1, 2, 3} }", "test:1: kit.new: option 'size': {width, height} expected, got {1, 2, 3}"},
      {"kit.new { size = {1, 0/0} }", "test:1: kit.new: option 'size': {width, height} expected, got {1, nan}"},
      {"kit.new {}", "test:1: kit.new: option 'size': missing, {width, height} expected"},
      {"kit.new()", "test:1: kit.new: option 'size': missing, {width, height} expected"},
      {"kit.new(3)", "test:1: kit.new: argument 1 ('options'): table of options expected, got number 3"},
      {"kit.new { size = {1, 1}, nmae = 'x' }",
       "test:1: kit.new: unknown option 'nmae'; did you mean 'name'? (known: size, name, gait, legs, route, spare)"},
      {"kit.new { 'x' }",
       "test:1: kit.new: options by name expected, got string \"x\" without a name (known: size, name, "
       "gait, legs, route, spare)"},
      {"kit.new { size = {1, 1}, gait = 'trott' }",
       "test:1: kit.new: option 'gait': unknown value 'trott', one of 'walk', 'trot'; did you mean 'trot'?"},
      {"kit.new { size = {1, 1}, legs = { cuont = 3 } }",
       "test:1: kit.new: unknown option 'legs.cuont'; did you mean 'count'? (known: count, length)"},
      {"kit.new { size = {1, 1}, legs = { count = '3' } }",
       "test:1: kit.new: option 'legs.count': integer expected, got string \"3\""},
      {"kit.new { size = {1, 1}, legs = { length = 30 } }",
       "test:1: kit.new: option 'legs.length': a number from 0 to 2 [m] expected, got 30"},
      {"kit.new { size = {1, 1}, spare = 'shrot' }",
       "test:1: kit.new: option 'spare': unknown value 'shrot', one of 'short', 'long'; did you mean 'short'?"},
      {"kit.new { size = {1, 1}, spare = { preset = 3 } }",
       "test:1: kit.new: option 'spare.preset': string expected, got number 3"},
      {"kit.new { size = {1, 1}, spare = { preset = 'long', count = 0 } }",
       "test:1: kit.new: option 'spare.count': a number from 1 to 8 expected, got 0"},
      {"kit.new { size = {1, 1}, route = { {1, 2}, {3} } }",
       "test:1: kit.new: option 'route[2]': {x, y} expected, got {3}"},
      {"r = kit.new { size = {1, 1} } r.grow(1)",
       "test:1: robot:grow: self: robot expected, got number 1 (call it with ':')"},
      {"r = kit.new { size = {1, 1} } r.copy()",
       "test:1: robot:copy: self: robot expected, got nothing (call it with ':')"},
      {"r = kit.new { size = {1, 1} } r:grow(-1)", "test:1: robot:grow: by: a positive number expected, got -1"},
      {"r = kit.new { size = {1, 1} } r:grwo(1)",
       "test:1: robot: has no member 'grwo'; did you mean 'grow'? (known: grow, copy, same, each, size, name, at)"},
      {"r = kit.new { size = {1, 1} } return r.siez",
       "test:1: robot: has no member 'siez'; did you mean 'size'? (known: grow, copy, same, each, size, name, at)"},
      {"r = kit.new { size = {1, 1} } r.siez = 3",
       "test:1: robot: has no property to set called 'siez'; did you mean 'size'? (known: name)"},
      {"r = kit.new { size = {1, 1} } r.size = 3", "test:1: robot.size: cannot be set"},
      {"r = kit.new { size = {1, 1} } r.name = 3", "test:1: robot.name: value: string expected, got number 3"},
      {"kit.misbehave 'memory'", "test:1: kit.misbehave: not enough memory"},
  };
  for (const auto& [script, message] : cases) EXPECT_EQ(run(script), std::string("error: ") + message) << script;
}

TEST_F(Kit, PositionIsTheScriptLineAlsoThroughCFunctions) {
  EXPECT_EQ(run("\n\nlocal ok, e = pcall(kit.add, 'x') return e"),
            "test:3: kit.add: argument 1 ('a'): number expected, got string \"x\"");
  EXPECT_EQ(run("local co = coroutine.create(function()\n kit.add() end) local ok, e = coroutine.resume(co) return e"),
            "test:2: kit.add: argument 1 ('a'): number expected, got nothing");
}

TEST_F(Kit, DestructorsRunWhenAnErrorPasses) {
  destroyed = 0;
  run("kit.new { size = {1, 1} }:grow(-1)");
  EXPECT_EQ(destroyed, 1);
  run("kit.new { size = {1, 1} }:each(function() error 'lua' end)");
  EXPECT_EQ(destroyed, 2);
  session_.stop.request();
  EXPECT_EQ(run("kit.spin()"), "error: interrupted");
  session_.stop.clear();
  EXPECT_EQ(destroyed, 3);
}

TEST_F(Kit, AStoppedCallStopsAgainAfterPcall) {
  session_.stop.request();
  EXPECT_EQ(run("pcall(kit.spin) kit.spin()"), "error: interrupted");
}

TEST_F(Kit, CallbackErrorsKeepTheirPositionAndValue) {
  EXPECT_EQ(run("local r = kit.new { size = {1, 1} }\nr:each(function(p)\n error('mine') end)"), "error: test:3: mine");
  EXPECT_EQ(run("local r = kit.new { size = {1, 1} } local t = {}\n"
                "local ok, e = pcall(r.each, r, function() error(t) end) return e == t"),
            "true");
  EXPECT_EQ(run("return kit.new { size = {2, 1} }:each(function(p) return p.x + p.y end)"), "9.0");
  EXPECT_EQ(run("kit.new { size = {2, 1} }:each(function(p) end)"),
            "error: test:1: robot:each: argument 1 ('visit'): result: number expected, got nil");
  EXPECT_EQ(run("kit.new { size = {2, 1} }:each(3)"),
            "error: test:1: robot:each: argument 1 ('visit'): function expected, got number 3");
}

TEST_F(Kit, CallbacksRunInTheCoroutineThatCalls) {
  EXPECT_EQ(run("local inside\n"
                "local co = coroutine.create(function()\n"
                "  kit.run_all { function() inside = coroutine.running() end }\n"
                "  local other = coroutine.wrap(function() kit.run_all { function() end } end)\n"
                "  kit.run_all { other, function() assert(coroutine.running() == inside) end }\n"
                "end)\n"
                "assert(coroutine.resume(co))\n"
                "return inside == co"),
            "true");
  EXPECT_EQ(run("return coroutine.wrap(function() kit.run_all { coroutine.yield } end)()"),
            "error: test:1: attempt to yield across a C-call boundary");
}

TEST_F(Kit, FunctionsOutliveTheStateSafely) {
  run("kit.keep(function() return 42 end)");
  EXPECT_EQ(run("collectgarbage() return kit.call_kept()"), "42.0");
  close();
  EXPECT_THROW(kept.call(), Error);
  kept = {};
}

TEST_F(Kit, SameObjectSameUserdata) {
  EXPECT_EQ(run("r = kit.new { size = {1, 1} } return r:same() == r, rawequal(r:same(), r), r:copy() == r"),
            "true true false");
  EXPECT_EQ(run("t = {[r] = 'found'} return t[r:same()]"), "found");
  EXPECT_EQ(run("for i = 1, 100 do r = r:same() collectgarbage('step') end return r.size"), "1.0");
}

TEST_F(Kit, ClosedObjectsSaySo) {
  const int before = living;
  EXPECT_EQ(run("do local r <close> = kit.new { size = {1, 1} } keep = r end return tostring(keep)"), "closed robot");
  EXPECT_EQ(living, before);
  EXPECT_EQ(run("keep:grow(1)"), "error: test:1: robot:grow: self: the robot is closed");
  EXPECT_EQ(run("return keep.size"), "error: test:1: robot.size: self: the robot is closed");
  EXPECT_EQ(run("return keep[1]"), "error: test:1: robot.[i]: self: the robot is closed");
}

TEST_F(Kit, AnObjectLivesAsLongAsTheCallThatUsesIt) {
  EXPECT_EQ(run("local r = kit.new { size = {1, 1} }\n"
                "local close = debug.getmetatable(r).__gc\n"
                "return r:each(function(p) close(r) return 1 end)"),
            "2.0");
}

TEST_F(Kit, MetatablesAreLockedAndSafeAgainstForeignValues) {
  EXPECT_EQ(run("r = kit.new { size = {1, 1} } return getmetatable(r), pcall(setmetatable, r, {})"),
            "locked false bad argument #1 to 'setmetatable' (table expected, got robot)");
  run("local gc = debug.getmetatable(r).__gc gc(io.stdout) gc(3) gc()");
  EXPECT_EQ(run("local index = debug.getmetatable(r).__index return pcall(index, io.stdout, 'size')"),
            "false test:1: robot.size: self: robot expected, got FILE*");
}

TEST_F(Kit, TheCollectorSeesNativeMemory) {
  run("r = nil collectgarbage()");
  int most = 0;
  for (int i = 0; i < 300; ++i) {
    run("kit.new { size = {1, 1} }");
    most = std::max(most, living);
  }
  EXPECT_LT(most, 30) << "dropped objects of 1 MB each alive at once";
}

TEST_F(Kit, RecordsTellTypesUnitsAndOptions) {
  const Record* record = session_.docs.find("kit.new");
  ASSERT_TRUE(record);
  EXPECT_EQ(record->signature(), "kit.new { options }");
  ASSERT_EQ(record->arguments.size(), 1u);
  const auto& options = record->arguments[0].options;
  ASSERT_EQ(options.size(), 6u);
  EXPECT_EQ(options[0].type, "{width, height}");
  EXPECT_TRUE(options[0].required);
  EXPECT_EQ(options[2].values, (std::vector<std::string>{"walk", "trot"}));
  EXPECT_EQ(options[2].standard, "'walk'");
  EXPECT_EQ(options[3].options.size(), 2u);
  EXPECT_EQ(options[5].values, (std::vector<std::string>{"short", "long"}));
  EXPECT_EQ(session_.docs.find("kit.add")->signature(), "kit.add(a, b?)");
  EXPECT_EQ(session_.docs.find("robot.grow"), session_.docs.find("robot:grow"));
  EXPECT_EQ(session_.docs.members("robot").size(), 7u);
  EXPECT_EQ(session_.docs.find("robot.size")->returns, "m");
}

}  // namespace
}  // namespace meander::script

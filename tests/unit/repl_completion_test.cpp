// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"
#include "script/interpreter.hpp"

namespace meander::script {
namespace {

using Words = std::vector<std::string>;

struct CompletionTest : testing::Test {
  Words words(std::string_view text) { return lua.complete(text).words; }
  bool offers(std::string_view text, const std::string& word) {
    const Words found = words(text);
    return std::find(found.begin(), found.end(), word) != found.end();
  }
  void run(const std::string& code) {
    const Outcome outcome = lua.run_text(code, "=test");
    ASSERT_TRUE(outcome.done()) << outcome.message;
  }
  Interpreter lua;
};

// No text makes it fail, and every word offered continues the text from where it says.
TEST_F(CompletionTest, OffersOnlyWhatContinuesTheText) {
  const Words parts = {"meander", "math",  ".",   ":",   "(",    ")", "{",     "}",   "[",  "]",        "=",
                       ",",       "world", "'",   "\"",  "open", "a", "[[",    "]]",  "--", "--[[",     "\n",
                       " ",       "1.5",   "sim", "new", "..",   "x", "sonar", "end", "\\", "\xc3\xa4", "require"};
  Stream random(3, "completion");
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (int k = random.below(12); k >= 0; --k)
      text += parts[static_cast<std::size_t>(random.below(static_cast<int>(parts.size())))];
    const Completion completion = lua.complete(text);
    ASSERT_LE(completion.start, text.size());
    ASSERT_TRUE(std::is_sorted(completion.words.begin(), completion.words.end()));
    for (const std::string& word : completion.words)
      ASSERT_TRUE(word.starts_with(text.substr(completion.start))) << text;
  }
}

TEST_F(CompletionTest, KnowsGlobalsKeywordsAndModules) {
  EXPECT_EQ(words("pri"), Words{"print"});
  EXPECT_EQ(words("x = pri"), Words{"print"});
  EXPECT_EQ(words("whi"), Words{"while"});
  EXPECT_TRUE(offers("wor", "world"));
  run("speed_of_light = 3e8");
  EXPECT_EQ(words("speed"), Words{"speed_of_light"});
  EXPECT_EQ(words("-- pri"), Words{});
  EXPECT_EQ(words("--[[ x ]] pri"), Words{"print"});
}

TEST_F(CompletionTest, FollowsFieldsAndElements) {
  run("a = { b = { { deep = 1, deeper = 2 } }, f = print, ['no name'] = 1 }");
  EXPECT_EQ(words("a."), (Words{"b", "f", "no name"}));
  EXPECT_EQ(words("a:"), Words{"f"});
  EXPECT_EQ(words("a.b[1].deepe"), Words{"deeper"});
  EXPECT_EQ(words("a['b'][1].deepe"), Words{"deeper"});
  EXPECT_EQ(words("math.floo"), Words{"floor"});
  EXPECT_EQ(words("a.nothing."), Words{});
  EXPECT_EQ(words("1 + "), words(""));
}

TEST_F(CompletionTest, FollowsIndexTablesButRunsNothing) {
  run("base = { inherited = print }  derived = setmetatable({ own = print }, { __index = base })"
      "ring = setmetatable({}, {})  getmetatable(ring).__index = ring  text = 'abc' "
      "trap = setmetatable({}, { __index = function() error 'ran' end, __pairs = error })");
  EXPECT_EQ(words("derived:"), (Words{"inherited", "own"}));
  EXPECT_EQ(words("derived.inh"), Words{"inherited"});
  EXPECT_EQ(words("ring.x"), Words{});
  EXPECT_EQ(words("text:upp"), Words{"upper"});
  EXPECT_EQ(words("trap.x."), Words{});
}

TEST_F(CompletionTest, KnowsWhatACallWillReturn) {
  EXPECT_EQ(words("meander.world.new {}:add_po"), Words{"add_polygon"});
  EXPECT_EQ(words("world.open('x'):add_po"), Words{"add_polygon"});
  EXPECT_EQ(words("world.open 'x':add_po"), Words{"add_polygon"});
  run("w = meander.world.new {}");
  EXPECT_EQ(words("w:add_po"), Words{"add_polygon"});
  EXPECT_EQ(words("w:fork():add_po"), Words{"add_polygon"});
}

TEST_F(CompletionTest, OffersOptionsAndTheirValues) {
  run("w = meander.world.new {}");
  EXPECT_EQ(words("w:add_box { cen"), Words{"center = "});
  EXPECT_EQ(words("w:add_box({ size = {1, 1}, cen"), Words{"center = "});
  EXPECT_TRUE(offers("w:add_box { size = {1, 1}, center = pri", "print"));
  EXPECT_EQ(words("w:add_box { size = { cen"), Words{});
  EXPECT_TRUE(offers("meander.sim.new { sonar = { ", "range_max = "));
}

TEST_F(CompletionTest, GoesIntoListsOfTables) {
  EXPECT_EQ(words("meander.sim.new { robots = { { ro"), Words{"robot = "});
  EXPECT_EQ(words("meander.sim.new { robots = { { robot = 'scout' }, { sonar = { noise_p"),
            Words{"noise_proportional = "});
  EXPECT_EQ(words("meander.sim.new { robots = { { robot = 'sc"), Words{"scout"});
  EXPECT_EQ(words("meander.sim.new { sonar = { preset = 'no"), Words{"nomad"});
}

TEST_F(CompletionTest, KnowsTheElementsOfListsAndViews) {
  run("w = meander.world.new { start = {2, 2, 0} }  s = meander.sim.new { world = w }  m = meander.matrix { {1} }");
  EXPECT_EQ(words("s.robots[1].travel"), Words{"travelled"});
  EXPECT_EQ(words("w:things()[i].ali"), Words{"alive"});
  EXPECT_EQ(words("m[1]:slic"), Words{"slice"});
  EXPECT_EQ(words("w:names()[1]."), Words{});
}

TEST_F(CompletionTest, FollowsWhatADriveGives) {
  run("s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } }");
  EXPECT_EQ(words("s:drive { navigator = 'potential_field', subgoals = {{4, 2}} }.clearance_mi"),
            Words{"clearance_min"});
  EXPECT_EQ(words("meander.world.import('x'):add_po"), Words{"add_polygon"});
}

TEST_F(CompletionTest, OffersNamesToHelp) {
  EXPECT_EQ(words("help 'sim:driv"), Words{"sim:drive"});
  EXPECT_EQ(words("help('study.wil"), Words{"study.wilson"});
}

TEST_F(CompletionTest, OffersWhatTheWorldHasThatIsMeant) {
  run("office = meander.world.open 'worlds/office.toml'  lab = meander.sim.new { world = office, seed = 7 }"
      "office:add_disc { center = {2, 1.2}, radius = 0.1, name = 'kiosk' }");
  EXPECT_EQ(words("lab:drive { subgoals = { 'ki"), Words{"kitchen"});
  EXPECT_EQ(words("lab:drive { navigator = 'polar', subgoals = { 'hall', \"ki"), Words{"kitchen"});
  EXPECT_EQ(words("lab:drive { pilots = { { subgoals = { {1, 2}, 'ki"), Words{"kitchen"});
  EXPECT_EQ(words("watch(lab, { subgoals = { 'ki"), Words{"kitchen"});
  EXPECT_EQ(words("sim.new { world = office, start = 'ki"), Words{"kitchen"});
  EXPECT_EQ(words("sim.new { seed = 2, world = office, start = 'ki"), Words{"kitchen"});
  EXPECT_EQ(words("office:thing 'ki"), (Words{"kiosk", "kitchen"}));
  EXPECT_EQ(words("office:remove { 'crate', 'ki"), (Words{"kiosk", "kitchen"}));
  EXPECT_EQ(words("office:move('kio"), Words{"kiosk"});
  EXPECT_EQ(words("lab.world:move('kio"), Words{"kiosk"});
  EXPECT_EQ(words("nobody:drive { subgoals = { 'ki"), Words{});
  EXPECT_EQ(words("meander.world.new {}:remove 'ki"), Words{});
}

TEST_F(CompletionTest, OffersElementsOfLists) {
  EXPECT_EQ(words("meander.render.save(s, 'a.svg', { hide = { 'cone', 'la"), Words{"label"});
}

TEST_F(CompletionTest, OffersOnlyFilesThatFit) {
  run("office = meander.world.open 'worlds/office.toml'  lab = meander.sim.new { world = office, seed = 7 }");
  EXPECT_EQ(words("world.open 'worlds/offi"), Words{"worlds/office.toml"});
  EXPECT_TRUE(offers("world.open '", "worlds/"));
  EXPECT_FALSE(offers("world.open '", "README.md"));
  EXPECT_FALSE(offers("world.open '", ".ci/"));
  EXPECT_TRUE(offers("world.open '.", ".ci/"));
  EXPECT_FALSE(offers("world.import 'READ", "README.md"));
  EXPECT_FALSE(lua.complete("world.open 'READ").file_name);
  EXPECT_TRUE(lua.complete("office:save '").file_name) << "by suffix, which is free";
  EXPECT_FALSE(lua.complete("lab:drive { subgoals = { 'READ").file_name) << "no file is wanted here";
  EXPECT_FALSE(lua.complete("lab:drive { nonsense = 'READ").file_name);
}

TEST_F(CompletionTest, LeavesQuotesToFilesAndModules) {
  EXPECT_TRUE(lua.complete("x = 'wor").file_name);
  EXPECT_TRUE(lua.complete("dofile 'wor").file_name);
  EXPECT_FALSE(lua.complete("x = 'done' .. pri").file_name);
  EXPECT_EQ(words("require 'meander.js"), Words{"meander.json"});
  EXPECT_EQ(words("require('meander.js"), Words{"meander.json"});
}

}  // namespace
}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class WorldScript : public ScriptState {
 protected:
  WorldScript() {
    bind_all(L);
    run("w = meander.world.new { title = 'yard', bounds = {{0, 0}, {12, 9}}, start = {1, 1, 0} }\n"
        "crate = w:add_box { center = {3, 2}, size = {0.6, 0.4}, heading = deg(30), name = 'crate' }\n"
        "hall = w:add_place { position = {8, 5}, name = 'hall' }");
  }
};

TEST_F(WorldScript, PrintsWhatMatters) {
  EXPECT_EQ(run("return w"), "world \"yard\": 12.0 x 9.0 m, 1 obstacle, 1 place");
  EXPECT_EQ(run("return crate"), "obstacle 1 \"crate\"");
  EXPECT_EQ(run("return hall, hall.name, hall.kind, hall.number, hall.alive, hall.world == w"),
            "place 2 \"hall\" hall place 2 true true");
}

TEST_F(WorldScript, AddsEveryKindOfThing) {
  EXPECT_EQ(run("return w:add_wall { points = {{5, 1}, {6, 1}}, closed = false }"), "obstacle 3 \"obstacle 3\"");
  EXPECT_EQ(run("return w:add_polygon { outer = {{5, 3}, {6, 3}, {6, 4}}, name = 'wedge' }"), "obstacle 4 \"wedge\"");
  EXPECT_EQ(run("return w:add_disc { center = {2, 7}, radius = 0.2 }"), "obstacle 5 \"obstacle 5\"");
  EXPECT_EQ(run("return w:add_door { from = {10, 1}, to = {11, 1}, open = true, name = 'gate' }"), "door 6 \"gate\"");
  EXPECT_EQ(run("return w:add_mover { center = {10, 7}, radius = 0.2, waypoints = {{11, 8}}, name = 'anna' }"),
            "mover 7 \"anna\"");
  EXPECT_EQ(run("return w:add_light { position = {1, 8}, name = 'lamp' }"), "light 8 \"lamp\"");
  EXPECT_EQ(run("return w"), "world \"yard\": 12.0 x 9.0 m, 4 obstacles, 1 door, 1 mover, 1 light, 1 place");
  EXPECT_EQ(run("return table.concat(w:names '*a*', ' ')"), "crate hall obstacle 3 obstacle 5 gate anna lamp");
  EXPECT_EQ(run("return #w:things 'obstacle*', w:thing 'anna'"), "2 mover 7 \"anna\"");
  EXPECT_EQ(run("return #w:obstacles(), #w:places(), w:places()[1] == hall"), "4 1 true");
}

TEST_F(WorldScript, EditsAndUndoes) {
  run("before = w:fork()");
  EXPECT_EQ(run("w:move('crate', {1, 0}) return w:get('crate').center, w == before"), "{4, 2} false");
  EXPECT_EQ(run("w:turn(crate, deg(60)) return w:get(crate).heading - math.pi / 2 < 1e-9"), "true");
  EXPECT_EQ(run("w:scale({'crate'}, 2) return w:get('crate').size"), "{1.2, 0.8}");
  EXPECT_EQ(run("w:rename('crate', 'chest') return crate.name"), "chest");
  EXPECT_EQ(run("w:snap('c*', 0.5) return w:get('chest').center.x"), "4.0");
  EXPECT_EQ(run("w:undo(-1)"),
            "error: test:1: world:undo: argument 1 ('steps'): an integer from 0 on expected, got -1");
  EXPECT_EQ(run("return w:undo(5), w == before, crate.name, w:hash() == before:hash()"), "5 true crate true");
  EXPECT_EQ(run("return w:redo(100), crate.name"), "5 chest");
  EXPECT_EQ(run("w:remove 'chest' return crate, crate.alive"), "removed thing 1 false");
  EXPECT_EQ(run("w:undo() return crate, crate.alive"), "obstacle 1 \"chest\" true");
}

TEST_F(WorldScript, ReplacesAndSetsHeader) {
  EXPECT_EQ(
      run("w:replace('crate', { center = {3, 2}, radius = 0.5 }) return w:get('crate').radius, w:get('crate').name"),
      "0.5 crate");
  EXPECT_EQ(run("w:set { title = 'court' } return w.title, w.start, w.bounds[2].x"), "court {1, 1, 0} 12.0");
  EXPECT_EQ(run("w:set { start = false } return w.start, w.title"), "nil court");
  EXPECT_EQ(run("w:add_door { from = {10, 1}, to = {11, 1}, name = 'gate' } w:open 'gate' return w:get('gate').open"),
            "true");
  EXPECT_EQ(run("w:close 'gate' return w:get('gate').open, w:get('gate').from"), "false {10, 1}");
}

TEST_F(WorldScript, TransactionsAreAllOrNothing) {
  EXPECT_EQ(run("local copy = w:fork()\n"
                "local ok, e = pcall(w.transaction, w, function()\n"
                "  w:remove 'crate'\n"
                "  w:add_disc { center = {2, 2}, radius = -1 }\n"
                "end)\n"
                "return ok, w == copy"),
            "false true");
  EXPECT_EQ(run("w:transaction(function() error('mine') end)"), "error: test:1: mine");
  EXPECT_EQ(run("w:transaction(function() w:remove 'crate' w:remove 'hall' end) return w:undo(), #w:names()"), "1 2");
}

TEST_F(WorldScript, LogAndTomlRebuildTheWorld) {
  run("w:move('crate', {1, 0}) w:set { note = 'n' } w:rename(hall, 'lobby')");
  EXPECT_EQ(run("local again = load(w:log())() return again == w, again:undo(5), w:undo(5), again == w, w:redo(5)"),
            "true 5 5 true 5");
  EXPECT_EQ(run("return meander.world.from_toml(w:to_toml()) == w"), "true");
  EXPECT_EQ(run("local path = os.tmpname() .. '.toml' w:save(path) local v = meander.world.open(path) os.remove(path)\n"
                "return v == w, #w:diff(v)"),
            "true 0");
  EXPECT_EQ(run("local v = w:fork() v:remove 'crate' return table.concat(w:diff(v), ';')"), "removed obstacle 'crate'");
}

TEST_F(WorldScript, SavesPictures) {
  EXPECT_EQ(run("local path = os.tmpname() .. '.svg' w:save(path) local f <close> = io.open(path) os.remove(path)\n"
                "return f:read(5), f:read 'a':find('</svg>') ~= nil"),
            "<svg  true");
}

TEST_F(WorldScript, MessagesOfTheCommonMistakes) {
  const std::pair<const char*, const char*> cases[] = {
      {"w:add_box { center = {3, 2}, size = 3 }",
       "test:1: world:add_box: option 'size': {width, height} expected, got number 3"},
      {"w:add_box { center = {3, 2}, size = {1, 1}, nmae = 'x' }",
       "test:1: world:add_box: unknown option 'nmae'; did you mean 'name'? (known: center, size, heading, name, echo, "
       "specular_limit)"},
      {"w:move('crat', {1, 0})", "test:1: world:move: no 'crat' in this world; did you mean 'crate'?"},
      {"w.move('crate', {1, 0})", "test:1: world:move: self: world expected, got string \"crate\" (call it with ':')"},
      {"w:move('x*', {1, 0})", "test:1: world:move: no thing fits the pattern 'x*'"},
      {"w:open 'crate'", "test:1: world:open: obstacle 'crate' is no door"},
      {"w:add_box { center = {3, 2}, size = {1, 1}, name = 'crate' }",
       "test:1: world:add_box: the name 'crate' is taken by an obstacle"},
      {"w:add_polygon { outer = {{5, 3}, {6, 4}, {6, 3}, {5, 4}} }",
       "test:1: world:add_polygon: obstacle 'obstacle 3': edge 2-3 and edge 4-1 meet at (5.5, 3.5)"},
      {"w:add_box { center = {8, 5}, size = {1, 1} }",
       "test:1: world:add_box: obstacle 'obstacle 3' covers place 'hall' at (8, 5)"},
      {"w:add_disc { center = {0/0, 5}, radius = 1 }",
       "test:1: world:add_disc: option 'center': {x, y} expected, got {nan, 5}"},
      {"w:add_door { open = true }",
       "test:1: world:add_door: one shape expected: from and to, points, outer, center and size, or center and radius; "
       "got none"},
      {"w:add_door { from = {1, 2} }", "test:1: world:add_door: option 'to': missing, {x, y} expected"},
      {"w:save 'x.pgn'", "test:1: world:save: x.pgn: unknown suffix, .toml, .svg or .png expected"},
      {"w:remove 'crate' w:move(crate, {1, 0})", "test:1: world:move: obstacle 'crate' was removed"},
      {"meander.world.opne 'none.toml'",
       "test:1: meander.world: has no member 'opne'; did you mean 'open'? (known: new, open, from_toml, import, "
       "generate, labyrinth)"},
      {"w.tilte = 3", "test:1: world: has no property to set called 'tilte'; did you mean 'title'?"},
      {"w.move = 3", "test:1: world: 'move' cannot be set"},
      {"w.title = 3", "test:1: world.title: cannot be set"},
  };
  for (const auto& [script, message] : cases) {
    EXPECT_EQ(run(script), std::string("error: ") + message) << script;
  }
}

TEST_F(WorldScript, HandlesMeanTheSameThingInForksOnly) {
  EXPECT_EQ(run("local v = w:fork() v:move(crate, {1, 0}) return v:get('crate').center, w:get(crate).center"),
            "{4, 2} {3, 2}");
  const std::string refused = "the thing 'crate' is of another world, and here no thing has its number and name";
  EXPECT_EQ(run("meander.world.new {}:get(crate)"), "error: test:1: world:get: " + refused);
  EXPECT_EQ(run("v = meander.world.new { bounds = {{0, 0}, {9, 9}} }\n"
                "for i = 1, 5 do v:add_light { position = {1, 1} } end\n"
                "v:add_disc { center = {5, 5}, radius = 1, name = 'crate' }\nv:remove(crate)"),
            "error: test:4: world:remove: " + refused);
  EXPECT_EQ(run("local v = w:fork() v:rename('crate', 'box') v:remove(crate)"),
            "error: test:1: world:remove: " + refused);
  EXPECT_EQ(run("local v = w:fork() v:remove(crate) return w:thing('crate').alive, pcall(v.thing, v, 'crate')"),
            "true false test:1: world:thing: no 'crate' in this world");
}

TEST_F(WorldScript, AnExactNameWinsOverThePattern) {
  run("for i, name in ipairs { 'a*b', 'axb', 'a?' } do w:add_light { position = {i, 1}, name = name } end");
  EXPECT_EQ(run("w:remove 'a*b' return table.concat(w:names 'a*', ' ')"), "axb a?");
  EXPECT_EQ(run("w:remove { 'a?', 'a*b' } return #w:names 'a*'"), "0");
}

TEST_F(WorldScript, NamesTheKeyOfABadSize) {
  EXPECT_EQ(
      run("w:add_box { center = {2, 2}, size = {1, -1} }"),
      "error: test:1: world:add_box: obstacle 'obstacle 3': size: height: a number from 1e-06 to 1e+06 m expected, "
      "got -1");
  EXPECT_EQ(run("w:turn('crate', 1e7)"),
            "error: test:1: world:turn: turn: an angle within +-1e+06 rad expected, got 10000000");
}

TEST_F(WorldScript, ShowsAPicture) {
  std::string shown;
  session_.write = [&](std::string_view text) { shown += text; };
  run("show(w)");
  EXPECT_NE(shown.find('#'), std::string::npos) << shown;
}

TEST_F(WorldScript, ShippedWorldsHaveAFolder) {
  EXPECT_EQ(run("return meander.world.open(meander.data_folder() .. '/worlds/office.toml').title"), "office");
}

}  // namespace
}  // namespace meander::script

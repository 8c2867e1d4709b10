// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What members say agrees with what is known about the case by other ways.
#include <gtest/gtest.h>

#include "own_folder.hpp"
#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class Members : public ScriptState {
 protected:
  Members() {
    bind_all(L);
    // A room of 6 x 4 m; the robot stands 2 m from the walls at its left and at its right and 4 m from that ahead.
    run("room = meander.world.new { bounds = {{0, 0}, {6, 4}}, start = {2, 2, 0} }\n"
        "room:add_wall { points = {{0, 0}, {6, 0}, {6, 4}, {0, 4}}, closed = true, name = 'rim' }\n"
        "sim = meander.sim.new { world = room, robot = 'nomad200', sonar = 'ideal', seed = 3 }\n"
        "radius = sim.state.radius\n"
        "function near(a, b, by) return math.abs(a - b) <= (by or 1e-9) end");
  }
};

TEST_F(Members, ListsOfNamesAreWhatTheOptionsTake) {
  EXPECT_EQ(run("for _, name in ipairs(meander.autonomy.navigators()) do\n"
                "  assert(meander.autonomy.navigator(name).name == name)\n"
                "end\n"
                "for _, name in ipairs(meander.robot.platforms()) do\n"
                "  local s = meander.sim.new { world = room, robot = name }\n"
                "  assert(s.state.platform == name)\n"
                "  assert(s.state.radius == meander.robot.platform(name).body.radius)\n"
                "end\n"
                "for _, name in ipairs(meander.sensor.sonars()) do\n"
                "  assert(meander.sensor.scan { world = room, sonar = name }.range_max == "
                "meander.sensor.sonar(name).range_max)\n"
                "end"),
            "");
  EXPECT_EQ(run("return #meander.autonomy.navigators() > 0, #meander.robot.platforms(), #meander.sensor.sonars()"),
            "true 3 3");
}

TEST_F(Members, ARayMeetsTheWallThatStandsThere) {
  EXPECT_EQ(run("local range, thing, point = meander.sensor.ray { world = room, from = {2, 2}, heading = deg(90) }\n"
                "return near(range, 2), thing.name, near(point.x, 2), near(point.y, 4)"),
            "true rim true true");
  EXPECT_EQ(run("return meander.sensor.ray { world = room, from = {2, 2}, range = 3.9 }"), "nil nil nil");
}

TEST_F(Members, AReadingTellsWhereItsEchoesAre) {
  run("reading = meander.sensor.scan { world = room, sonar = { preset = 'ideal' }, pose = {2, 2, 0} }");
  EXPECT_EQ(run("return #reading.ranges == #reading.transducers, reading.pose, reading.range_max > 6"),
            "true {2, 2, 0} true");
  // The first transducer looks ahead, the fifth of sixteen to the left: 4 m and 2 m less the ring's radius.
  EXPECT_EQ(run("local r, t = reading.ranges, reading.transducers\n"
                "return near(r[1], 6 - t[1].x, 1e-6), near(r[5], 4 - t[5].y, 1e-6), near(t[5].heading, deg(90))"),
            "true true true");
  EXPECT_EQ(
      run("local heard, echoes = reading:points(), 0\n"
          "for _, range in ipairs(reading.ranges) do if range < reading.range_max then echoes = echoes + 1 end end\n"
          "return #heard == echoes, near(heard[1].x, 6, 1e-6), near(heard[1].y, 2, 1e-6)"),
      "true true true");
}

TEST_F(Members, DrivingIntoAWallIsAContactOfItsOwnFault) {
  EXPECT_EQ(run("return sim.state.clearance, 2 - radius, sim.state.touching"),
            run("return 2 - radius, 2 - radius, false"));
  run("while sim.time < 30 do sim:step(0.3, 0) end");
  EXPECT_EQ(run("local s = sim.state return s.touching, s.contacts, s.fault_contacts, near(s.clearance, 0, 1e-3)"),
            "true 1 1 true");
  EXPECT_EQ(run("sim:reset() for i = 1, 9 do sim:step(0, 0.2) end\n"
                "return near(sim.state.w, 0.2), near(sim.observation.w, 0.2), sim.state.v, sim.state.fault_contacts"),
            "true true 0.0 0");
}

TEST_F(Members, FiguresOfARunAreThoseOfItsTraces) {
  run("run = sim:drive { navigator = 'potential_field', subgoals = { {4, 2.5}, {2, 1} } }\n"
      "heading, clearance = run:trace 'heading', run:trace 'clearance'\n"
      "turned = math.abs(heading[1])\n"
      "for i = 2, #heading do\n"
      "  local by = heading[i] - heading[i - 1]\n"
      "  turned = turned + math.abs(math.atan(math.sin(by), math.cos(by)))\n"
      "end");
  EXPECT_EQ(run("return run.success, run.trapped, run.contacts, run.fault_contacts"), "true 0 0 0");
  EXPECT_EQ(run("return near(run.turning, turned, 1e-6), turned > deg(90)"), "true true");
  EXPECT_EQ(run("return run.clearance_min <= run.clearance_mean, run.clearance_mean <= clearance:max()"), "true true");
  EXPECT_EQ(run("return run.jerk > 0, run.cpu_per_cycle > 0, run.cpu_per_cycle < 0.1"), "true true true");
  // Standing still is as smooth as can be.
  EXPECT_EQ(
      run("local r = sim:drive { navigator = function() return 0, 0 end, subgoals = { {4, 2} }, time_limit = 3 }\n"
          "return r.success, sim:drive { navigator = function() return 0, 0, 'trapped' end,\n"
          "  subgoals = { {4, 2} }, time_limit = 3 }.trapped > 0"),
      "false true");
}

TEST_F(Members, WorldsKeepTheirNotesAndGoOutAsMaps) {
  EXPECT_EQ(run("room:set { note = 'measured by hand' } return room.note"), "measured by hand");
  EXPECT_EQ(run("room:undo() return room.note"), "");
  const std::string map = (own_folder() / "maps" / "room.yaml").string();
  run("path = '" + map + "'");
  EXPECT_EQ(run("meander.make_folder(path:match '(.*)/') meander.make_folder(path:match '(.*)/')\n"
                "room:export_ros(path, { resolution = 0.05 })\n"
                "local back = meander.world.import(path)\n"
                "local range = meander.sensor.ray { world = back, from = {2, 2} }\n"
                "return near(range, 4, 0.1)"),
            "true");
  EXPECT_TRUE(run("meander.make_folder(path)").starts_with("error: test:1: meander.make_folder: "));
}

TEST_F(Members, EveryLocalNavigatorCrossesAFreeRoom) {
  EXPECT_EQ(run("local polar = meander.polar\n"
                "for _, make in ipairs { polar.potential_field, polar.vfh_plus, polar.dynamic_window, "
                "polar.tangent_bug } do\n"
                "  local navigator = make { robot = 'nomad200' }\n"
                "  sim:reset()\n"
                "  local run = sim:drive { navigator = navigator, subgoals = { {4, 2.5} }, time_limit = 60 }\n"
                "  assert(run.success and run.contacts == 0 and run.navigator == navigator.name, navigator.name)\n"
                "end"),
            "");
}

TEST_F(Members, MatricesAndGeneratedWorlds) {
  EXPECT_EQ(run("local m = meander.matrix { {1, 2}, {3, 4}, {5, 6} } return m.rows, m.columns, #m, #m[1]"), "3 2 3 2");
  EXPECT_EQ(run("local function hash(seed) return meander.world.generate { seed = seed }:hash() end\n"
                "return hash(1) == hash(1), hash(1) == hash(2)"),
            "true false");
}

TEST_F(Members, KindsAndNamesThatAreNear) {
  EXPECT_EQ(run("return meander.kind(sim), meander.kind(sim.world), meander.kind(1), meander.kind(nil), "
                "meander.kind(print), meander.kind(io.stdout)"),
            "sim world number nil function FILE*");
  EXPECT_EQ(run("return meander.did_you_mean('sede', { 'time', 'seed' })"), "; did you mean 'seed'?");
  EXPECT_EQ(run("return meander.did_you_mean('xyz', { 'time', 'seed' })"), "");
}

}  // namespace
}  // namespace meander::script

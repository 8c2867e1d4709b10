// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "own_folder.hpp"
#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class MapScript : public ScriptState {
 protected:
  MapScript() {
    bind_all(L);
    run("folder = '" + own_folder().string() +
        "/'\n"
        "w = meander.world.new { bounds = {{0, 0}, {6, 6}}, start = {3, 3, 0} }\n"
        "w:add_wall { points = { {0, 0}, {6, 0}, {6, 6}, {0, 6} }, closed = true }\n"
        "w:add_box { center = {4.2, 3}, size = {0.4, 2} }\n"
        "s = meander.sim.new { world = w, sonar = 'ideal', seed = 3 }\n"
        "m = meander.mapping.map { model = 'elfes' }\n"
        "for i = 1, 30 do m:update(s.observation) s:step(0.05, 0.4) end");
  }
};

TEST_F(MapScript, TellsWhatItHasSeen) {
  EXPECT_EQ(run("return m.scans, m.size, m.resolution, m.model, m.fusion"), "30 60 0.05 elfes viewbin");
  EXPECT_EQ(run("return m:probability(4.02, 3) > 0.6, m:probability(3.4, 3) < 0.3, m:probability(4.3, 3), "
                "m:probability(99, 3)"),
            "true true 0.5 0.5");
  EXPECT_EQ(run("l, g = m:matrix 'local', m:matrix() return l.rows, l.columns, g.rows >= l.rows - 30, "
                "m:bounds('local')[1].x < 3"),
            "60 60 true true");
  EXPECT_EQ(run("return tostring(m)"), "map: model elfes, fusion viewbin, 30 scans, window of 60 x 60 cells of 0.05 m");
}

TEST_F(MapScript, ScoresItAgainstTheTruth) {
  EXPECT_EQ(run("k = meander.study.map_score(m, s) return k.free > 500, k.occupied > 10, k.auc > 0.8, k.ce < 0.69, "
                "#k.reliability"),
            "true true true true 10");
  EXPECT_EQ(run("t = meander.study.map_truth(m, s):all() return #t, (t:max()), (t:min())"), "3600 2.0 0.0");
}

TEST_F(MapScript, RosMapComesBackAsAWorld) {
  EXPECT_EQ(run("m:save(folder .. 'map.yaml') back = meander.world.import(folder .. 'map.yaml', { unknown = 'free' }) "
                "return meander.sensor.ray { world = back, from = {3, 3}, heading = 0, range = 3 } ~= nil"),
            "true");
  // What is in the way in the world that came back is where the map shows it.
  EXPECT_EQ(run("r = meander.sensor.ray { world = back, from = {3, 3}, heading = 0, range = 3 } "
                "return math.abs(r - 1) < 0.1"),
            "true");
  EXPECT_EQ(run("m:save(folder .. 'map.png', 'local') m:save(folder .. 'map.pgm') return m:save(folder .. 'map.txt')")
                .substr(0, 22),
            "error: test:1: map:sav");
}

TEST_F(MapScript, DrawsItself) {
  EXPECT_EQ(run("meander.render.save(m, folder .. 'map.svg') meander.render.save(m:picture 'local', folder .. 'l.png') "
                "return 'drawn'"),
            "drawn");
  EXPECT_EQ(run("m:clear() return m.scans, m:probability(3.4, 3)"), "0 0.5");
  EXPECT_NE(run("meander.render.save(m, folder .. 'x.svg')").find("the map is empty"), std::string::npos);
}

TEST_F(MapScript, MistakesAreTold) {
  EXPECT_NE(run("meander.mapping.map { model = 'elfs' }").find("did you mean 'elfes'?"), std::string::npos);
  EXPECT_NE(run("meander.mapping.map { model = 'elfes', size = 1 }").find("option 'size'"), std::string::npos);
  EXPECT_NE(run("meander.mapping.map({ model = 'elfes', global = false }):matrix 'global'").find("no global map"),
            std::string::npos);
}

TEST_F(MapScript, RobotWithoutSonarsIsRefused) {
  for (const std::string model : {"'elfes'", "'ros'", "'nn4'", "function() return {} end"})
    EXPECT_NE(run("meander.mapping.map { model = " + model + ", robot = 'alice' }").find("error: test:1:"),
              std::string::npos)
        << model;
  EXPECT_NE(run("meander.mapping.map { model = 'elfes', robot = 'alice' }")
                .find("model \"elfes\": a ring of 1 sonar or more expected, got 0"),
            std::string::npos);
}

TEST_F(MapScript, NavigatorsUseIt) {
  EXPECT_EQ(run("n = meander.autonomy.map_navigator { map = { model = 'elfes' } } "
                "r = s:drive { navigator = n, subgoals = { {5.2, 3} }, time_limit = 60 } return r.success, r.contacts"),
            "true 0");
  EXPECT_EQ(run("s:reset() blind = meander.autonomy.map_safety(meander.autonomy.navigator 'potential_field', "
                "{ map = { model = 'elfes' } }) return tostring(blind)"),
            "navigator \"potential_field+safety\"");
}

TEST_F(MapScript, RecordedRunsMakeTheSameMap) {
  EXPECT_EQ(run("s:reset() online = meander.mapping.map { model = 'elfes' } "
                "r = s:drive { navigator = 'vfh_plus', subgoals = { {3, 5} }, time_limit = 30, "
                "on_step = function(sim) online:update(sim.observation) end } r:save(folder .. 'run.csv') "
                "log = meander.study.sonar_log(folder .. 'run.csv') return #log == online.scans, log.sonars, "
                "log.report.bad_ranges"),
            "true 16 0");
  EXPECT_EQ(run("offline = meander.mapping.map { model = 'elfes' } for i = 1, #log do offline:update(log[i]) end "
                "a, b, d = online:matrix('local'):all(), offline:matrix('local'):all(), 0 "
                "for i = 1, #a do d = math.max(d, math.abs(a[i] - b[i])) end return d < 0.01"),
            "true")
      << "ideal sonars fire at once, so nothing is lost but digits";
}

}  // namespace
}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "base/hash.hpp"
#include "own_folder.hpp"
#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class TopologyScript : public ScriptState {
 protected:
  TopologyScript() {
    bind_all(L);
    run("folder = '" + own_folder().string() + "/' worlds = '" + std::string(MEANDER_SOURCE_DIR) +
        "/worlds/'\n"
        "s = meander.sim.new { world = meander.world.open(worlds .. 'alice_loop.toml'), robot = 'alice', drift = "
        "'alice', seed = 5 }\n"
        "m, again = meander.topology.map {}, meander.topology.map {}\n"
        "again:step(s.observation)\n"
        "p = meander.study.place_scores(s)\n"
        "r = s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples = "
        "900 }, time_limit = 1e4, on_step = function() p:add(m) end }");
  }
};

TEST_F(TopologyScript, ARecordedRunWithoutTheTruthMakesTheSameMap) {
  EXPECT_EQ(run("r:save(folder .. 'run.csv')\n"
                "local truth = { x = true, y = true, heading = true, v = true, w = true, clearance = true, touching = "
                "true }\n"
                "local kept, rows = nil, {}\n"
                "for line in io.lines(folder .. 'run.csv') do\n"
                "  local cells, row = {}, {}\n"
                "  for cell in line:gmatch '[^,]+' do cells[#cells + 1] = cell end\n"
                "  if not kept then\n"
                "    kept = {}\n"
                "    for i, name in ipairs(cells) do if not truth[name] then kept[#kept + 1] = i end end\n"
                "    assert(#cells - #kept == 7)\n"
                "  end\n"
                "  for _, i in ipairs(kept) do row[#row + 1] = cells[i] end\n"
                "  rows[#rows + 1] = table.concat(row, ',')\n"
                "end\n"
                "local file = io.open(folder .. 'blind.csv', 'w')\n"
                "file:write(table.concat(rows, '\\n'), '\\n')\n"
                "file:close()\n"
                "local log = meander.study.sonar_log(folder .. 'blind.csv')\n"
                "for i = 1, #log do again:step(log[i]) end\n"
                "return #log, log.sonars, again.samples, again.source == m.source"),
            "900 0 901 true");
}

TEST_F(TopologyScript, TheSameBitsOnEveryMachine) {
  EXPECT_EQ(Hash().add(run("return m.source")).hex(), "1b73a16eee22f334");
}

TEST_F(TopologyScript, SavedInTheMiddleItGoesOnTheSame) {
  EXPECT_EQ(run("m:save(folder .. 'map.txt') o, c = meander.topology.open(folder .. 'map.txt'), m:copy()\n"
                "for i = 1, 200 do local x = s.observation c:step(x) o:step(x) s:step(0.1, 0.3) end\n"
                "return o.source == c.source, o.source == m.source, o.samples"),
            "true false 1101");
}

TEST_F(TopologyScript, JustOpenedItKnowsWhatIsSensed) {
  EXPECT_EQ(run("m:save(folder .. 'map.txt') o = meander.topology.open(folder .. 'map.txt')\n"
                "return o:alike() == m:alike(), o.source == m.source"),
            "true true");
}

TEST_F(TopologyScript, TellsPlacesLinksAndWays) {
  EXPECT_EQ(run("local l = m.links[1] return #m == #m.places, m.places[1].number, l.a < l.b, l.suspended, "
                "#m:way(l.a, l.b), m:nearest(m.places[3].position) == m.places[3].number"),
            "true 1 true false 2 true");
  EXPECT_EQ(run("return m:way(m:alike(), m:alike())[1] == m:alike()"), "true");
  EXPECT_EQ(run("local q = p:summary() return q.samples, q.error_mean < q.error_max, q.recall >= 0, "
                "p:true_place(m, m.winner) ~= nil"),
            "900 true true true");
  EXPECT_EQ(run("local e = p:map_error(m) return e > 0.05, e < 3, p:map_error(meander.topology.map {})"),
            "true true 0.0");
  EXPECT_EQ(run("return m:way(1, 100000)"), "error: test:1: topologic_map:way: place 100000 is not in the map");
}

TEST_F(TopologyScript, DrivesOverTheLinks) {
  EXPECT_EQ(
      run("goal = m.places[12].number at = p:true_place(m, goal)\n"
          "r = s:drive { navigator = meander.topology.whiskers { patience = 1e6 }, guide = meander.topology.route { "
          "map = m, to = goal }, time_limit = 1e4 }\n"
          "local pose = s.state.pose\n"
          "return r.success, r.reason, math.sqrt((pose[1] - at.x) ^ 2 + (pose[2] - at.y) ^ 2) < 0.5"),
      "true arrived, and the senses agree true");
  EXPECT_EQ(run("meander.topology.route { map = m, to = 100000 }"),
            "error: test:1: meander.topology.route: place 100000 is not in the map");
}

TEST_F(TopologyScript, DrawsAndExports) {
  EXPECT_EQ(run("m:save(folder .. 'map.graphml') m:save(folder .. 'map.dot')\n"
                "meander.render.save(m, folder .. 'map.svg') meander.render.save(m:over(s.world), folder .. 'o.svg')\n"
                "return io.open(folder .. 'map.dot'):read 'l', io.open(folder .. 'map.graphml'):read('a'):match "
                "'</graphml>'"),
            "graph places { </graphml>");
}

TEST_F(TopologyScript, OtherRobotsAreRefused) {
  EXPECT_EQ(run("meander.topology.map { robot = 'scout' }"),
            "error: test:1: meander.topology.map: robot 'scout' has no whiskers; one like 'alice' expected");
  EXPECT_EQ(run("local t = meander.sim.new { world = s.world } m:step(t.observation)"),
            "error: test:1: topologic_map:step: topologic map for 24 whiskers and 24 light sensors: got 0 and 0");
  EXPECT_EQ(run("meander.topology.map { correlation = { gian = 1 } }").substr(0, 65),
            "error: test:1: meander.topology.map: unknown option 'correlation.");
}

TEST_F(TopologyScript, RingsThatDoNotBeginAheadAreRefused) {
  const std::string whiskers = ": robot 'alice': whisker.first = 0 expected, the first one ahead; got 0.1";
  EXPECT_EQ(run("meander.topology.map { robot = { preset = 'alice', whisker = { first = 0.1 } } }"),
            "error: test:1: meander.topology.map" + whiskers);
  EXPECT_EQ(run("meander.topology.whiskers { robot = { preset = 'alice', whisker = { first = 0.1 } } }"),
            "error: test:1: meander.topology.whiskers" + whiskers);
  EXPECT_EQ(
      run("meander.topology.map { robot = { preset = 'alice', light = { first = -1 } } }"),
      "error: test:1: meander.topology.map: robot 'alice': light.first = 0 expected, the first one ahead; got -1");
}

TEST_F(TopologyScript, PlacesAndReachesThatAreNone) {
  EXPECT_EQ(run("m:way(math.mininteger, 1)").substr(0, 36), "error: test:1: topologic_map:way: ar");
  EXPECT_EQ(run("m:way(-2147483648, 1)"), "error: test:1: topologic_map:way: place -2147483648 is not in the map");
  EXPECT_EQ(run("m:way(0, 1)"), "error: test:1: topologic_map:way: place 0 is not in the map");
  EXPECT_EQ(run("meander.topology.map { correlation = { reach = 0 } }").substr(0, 15), "error: test:1: ");
  EXPECT_EQ(run("m:save(folder .. 'map.DOT') return io.open(folder .. 'map.DOT'):read 'l'"), "graph places {");
}

TEST_F(TopologyScript, OneMapOverTwoRuns) {
  EXPECT_EQ(
      run("m:begin {40, 30, 0}\n"
          "local t = meander.sim.new { world = s.world, robot = 'alice', drift = 'alice', seed = 6 }\n"
          "t:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map = m, samples "
          "= 300 }, time_limit = 1e4 }\n"
          "local far, at = 0, {}\n"
          "for _, p in ipairs(m.places) do at[p.number] = p.position far = far + (p.position.x > 20 and 1 or 0) "
          "end\n"
          "for _, l in ipairs(m.links) do assert((at[l.a].x > 20) == (at[l.b].x > 20)) end\n"
          "return far > 10"),
      "true");
  EXPECT_EQ(run("m:shift {2e6, 0}"),
            "error: test:1: topologic_map:shift: a number from -1e6 to 1e6 expected, got 2000000");
}

TEST_F(TopologyScript, AMinimalModelRefusesMapsOfOtherRobots) {
  const std::string fault = ": a map of the same robot expected, 24 whiskers and 24 light sensors; got one of 8 and 6";
  EXPECT_EQ(run("k = meander.topology.minimal { map = m } k:step(m)\n"
                "robot = { preset = 'alice', whisker = { count = 8 }, light = { count = 6 } }\n"
                "w = meander.sim.new { world = s.world, robot = robot }\n"
                "other = meander.topology.map { robot = robot } other:step(w.observation) return other.samples"),
            "1");
  EXPECT_EQ(run("k:step(other)"), "error: test:1: minimal_map:step" + fault);
  EXPECT_EQ(run("k:sizes(other)"), "error: test:1: minimal_map:sizes" + fault);
  EXPECT_EQ(run("k:recognise(other)"), "error: test:1: minimal_map:recognise" + fault);
  EXPECT_EQ(run("k:recognise(other, true)"), "error: test:1: minimal_map:recognise" + fault);
  EXPECT_EQ(run("k:recognise(meander.topology.map {})"),
            "error: test:1: minimal_map:recognise: the map has not taken in any sample yet");
}

}  // namespace
}  // namespace meander::script

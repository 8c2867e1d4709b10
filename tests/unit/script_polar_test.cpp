// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class PolarScript : public ScriptState {
 protected:
  PolarScript() {
    bind_all(L);
    run("w = meander.world.new { bounds = {{0, 0}, {8, 6}}, start = {1, 3, 0} }\n"
        "w:add_box { center = {3.5, 3}, size = {0.6, 0.8} }\n"
        "s = meander.sim.new { world = w, seed = 3 }");
  }
};

TEST_F(PolarScript, LooksInside) {
  EXPECT_EQ(
      run("n = meander.polar.navigator { map = { sectors = 32 } } "
          "for i = 1, 10 do local v, t = n:step(s.observation, {6, 3}) s:step(v, t) end "
          "l = n:inspect() return l.rings, l.sectors, #l.radii, #l.obstructed, l.target_ring, l.latency, l.traps"),
      "100 32 100 100 100 0 0");
  EXPECT_EQ(run("return l.subgoal.x > 1, #l.points > 0, #l.memory >= #l.points, l.residual < 1, l.escaping"),
            "true true true true false");
  EXPECT_EQ(run("return l.activation[100][1], l.activation[9]:max() > -60, (l.obstructed:all():max())"),
            "0.0 true 1.0");
  EXPECT_EQ(run("return #l.bearings, l.bearings[1], math.deg(l.bearings[9])"), "32 0.0 90.0");
  EXPECT_EQ(
      run("return meander.polar.potential_field({}):inspect()"),
      "error: test:1: navigator:inspect: navigator \"potential_field\": only polar navigators can be looked into");
}

TEST_F(PolarScript, LooksInsideOnlyOnceItHasDriven) {
  const std::string none =
      "error: test:1: navigator:inspect: navigator \"polar\" has not driven yet: there is no map to look into";
  EXPECT_EQ(run("n = meander.polar.navigator {} return n:inspect()"), none);
  EXPECT_EQ(run("n:step(s.observation, {6, 3}) return n:inspect().target > 4"), "true");
  EXPECT_EQ(run("n:reset() return n:inspect()"), none);
}

TEST_F(PolarScript, PartsCanBeWrittenInLua) {
  EXPECT_EQ(
      run("n = meander.polar.navigator { own = {\n"
          "  objective = function(c) return c.distance + 0.4 * c.heading_error + 10 * c.hard + 0.02 * c.soft end,\n"
          "  weights = function(r)\n"
          "    local along, across = (r.outer - r.inner) / 2, r.radius * r.spacing\n"
          "    return { inward = across / along, outward = across / along, lateral = along / across,\n"
          "             leak = 900 * along * across }\n"
          "  end,\n"
          "  subgoal = function(m)\n"
          "    local best, sector = -400, nil\n"
          "    for k = 1, m.sectors do\n"
          "      if m.activation[9][k] > best then best, sector = m.activation[9][k], k end\n"
          "    end\n"
          "    local ring = 9\n"
          "    while sector and ring < m.rings and m.activation[ring + 1][sector] > m.activation[ring][sector] do\n"
          "      ring = ring + 1\n"
          "    end\n"
          "    if sector then return ring, sector end\n"
          "  end } }\n"
          "r = s:drive { navigator = n, subgoals = { {6, 3} } } return r.success, r.contacts"),
      "true 0");
}

TEST_F(PolarScript, NavigatorsDriveOnlyTheBodyTheyAreMadeFor) {
  run("scout = meander.sim.new { world = w, robot = 'scout' } "
      "function go(n) return scout:drive({ navigator = n, subgoals = { {2, 3} } }).success end");
  EXPECT_EQ(run("return go(meander.polar.navigator {})"),
            "error: test:1: sim:drive: navigator 'polar': made for a robot of radius 0.2667 m; this one has 0.19 m");
  EXPECT_EQ(run("return meander.autonomy.map_safety(meander.polar.vfh_plus {}, { robot = 'scout', map = { model = "
                "'ros' } })"),
            "error: test:1: meander.autonomy.map_safety: navigator 'vfh_plus': made for a robot of radius 0.2667 m; "
            "this one has 0.19 m");
  EXPECT_EQ(run("return go(meander.polar.navigator { robot = 'scout' }), go 'vfh_plus'"), "true true");
}

TEST_F(PolarScript, MistakesAreTold) {
  EXPECT_EQ(
      run("meander.polar.navigator { own = { weights = function(r) return { inward = 1, outward = 1, lateral = 1, "
          "leak = -0.5 } end } }"),
      "error: test:1: meander.polar.navigator: weights: the activation would grow without bounds (largest gain 1.143, "
      "less than 1 expected); larger totals make it decay");
  EXPECT_EQ(run("n = meander.polar.navigator { own = { subgoal = function() return 1000, 2 end } } "
                "n:step(s.observation, {6, 3})"),
            "error: test:1: navigator:step: option 'own.subgoal': result: ring from 1 to 100 and sector from 1 to 48 "
            "expected, got ring 1000 and sector 2");
  EXPECT_EQ(run("meander.polar.navigator { map = { ring = 3 } }").substr(0, 75),
            "error: test:1: meander.polar.navigator: unknown option 'map.ring'; did you ");
}

}  // namespace
}  // namespace meander::script

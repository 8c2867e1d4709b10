// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class MapNavigatorsScript : public ScriptState {
 protected:
  MapNavigatorsScript() { bind_all(L); }
};

TEST_F(MapNavigatorsScript, SafetyTakesWhoeverDrives) {
  run("w = meander.world.new { bounds = { {0, 0}, {10, 10} } } w:add_wall { points = { {5, 0}, {5, 10} } } "
      "function contacts(who) s = meander.sim.new { world = w, start = {3, 5, 0}, sonar = 'ideal' } "
      "return s:drive { navigator = who, subgoals = { {7, 5} }, time_limit = 15, when_trapped = 'insist' "
      "}.fault_contacts "
      "end map = { map = { model = 'elfes' } } function straight() return 0.5, 0 end");
  EXPECT_EQ(run("return contacts(straight)"), "1");
  EXPECT_EQ(run("return contacts(meander.autonomy.map_safety(straight, map))"), "0");
  EXPECT_EQ(run("return contacts(meander.autonomy.map_safety({ step = straight, name = 'me' }, map))"), "0");
  EXPECT_EQ(run("return contacts(meander.autonomy.map_safety('polar', map))"), "0");
  EXPECT_NE(run("meander.autonomy.map_safety 'plar'").find("did you mean 'polar'?"), std::string::npos);
}

}  // namespace
}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "autonomy/navigators.hpp"
#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class SimScript : public ScriptState {
 protected:
  SimScript() {
    bind_all(L);
    run("w = meander.world.new { title = 'yard', bounds = {{0, 0}, {12, 9}}, start = {1, 1, 0} }\n"
        "w:add_wall { points = {{0, 0}, {12, 0}, {12, 9}, {0, 9}}, closed = true, name = 'rim' }\n"
        "w:add_place { position = {4, 1.5}, name = 'hall' }\n"
        "w:add_place { position = {7, 3}, name = 'goal' }\n"
        "function new(more)\n"
        "  local o = { world = w, robot = 'nomad200', seed = 7 }\n"
        "  for k, v in pairs(more or {}) do o[k] = v end\n"
        "  return meander.sim.new(o)\n"
        "end\n"
        "function straight(o, s) return 0.3, 0 end\n"
        "function home(o, s)\n"
        "  local bearing = math.atan(s.y - o.pose.y, s.x - o.pose.x) - o.pose.heading\n"
        "  bearing = math.atan(math.sin(bearing), math.cos(bearing))\n"
        "  return 0.5 * math.max(0, math.cos(bearing)), bearing\n"
        "end\n"
        "sim = new()");
  }
};

TEST_F(SimScript, StepsAndTellsWhatItSees) {
  EXPECT_EQ(run("return sim"), "sim: \"yard\", 1 robot, 0.0 s, at (1.00, 1.00) heading 0.00, seed 7");
  EXPECT_EQ(run("return sim.world == w, rawequal(sim.world, w), sim.pose, sim.seed, #sim.robots"),
            "true true {1, 1, 0} 7 1");
  EXPECT_EQ(run("local o = sim:step(0.3, 0) return #o.sonar, o.time == sim.period, o.pose.x > 1, o.v > 0, o.bumped"),
            "16 true true true false");
  EXPECT_EQ(
      run("local o = sim:step { v = 0.3, w = 0.1 } return o.time, #o.bumper, #o.sonar_poses, o.period == sim.period"),
      "0.66 20 16 true");
  EXPECT_EQ(run("return sim.state.pose == sim.pose, sim.state.travelled > 0, sim.state.contacts, sim.state.platform"),
            "true true 0 nomad200");
  EXPECT_EQ(run("sim:reset() return sim.time, sim.pose"), "0.0 {1, 1, 0}");
}

TEST_F(SimScript, SameSeedSameHashAlsoAcrossForkAndReset) {
  EXPECT_EQ(
      run("for i = 1, 20 do sim:step(0.3, 0.1) end first = sim:hash()\n"
          "local copy = sim:fork() copy:step(0.3, 0) local ahead = copy:hash()\n"
          "local same = sim:hash() == first\n"
          "sim:step(0.3, 0) local again = sim:hash() == ahead\n"
          "sim:reset() for i = 1, 20 do sim:step(0.3, 0.1) end\n"
          "return same, again, sim:hash() == first, #first, copy.world == sim.world, rawequal(copy.world, sim.world)"),
      "true true true 16 true false");
  EXPECT_EQ(run("sim:reset(8) for i = 1, 20 do sim:step(0.3, 0.1) end return sim:hash() == first"), "false");
}

TEST_F(SimScript, ObservationsKeepWhatTheySaw) {
  EXPECT_EQ(run("local o = sim.observation local view = o.sonar local r = view[1]\n"
                "o = nil collectgarbage() for i = 1, 30 do sim:step(0.5, 0.1) end collectgarbage()\n"
                "return view[1] == r, sim.observation.sonar[1] == r"),
            "true false");
}

TEST_F(SimScript, DrivesThroughPlacesAndPoints) {
  EXPECT_EQ(run("run = sim:drive { navigator = home, subgoals = { 'hall', {6, 2}, w:thing 'goal' } }\n"
                "return run.reached, run.subgoals, run.success, run.contacts, run.seed, run.goals[1].name, #run.hash"),
            "3 3 true 0 7 hall 16");
  const std::string text = run("return run");
  EXPECT_TRUE(text.starts_with("run: 3/3 subgoals, ")) << text;
  EXPECT_NE(text.find(" contacts, clearance min "), std::string::npos) << text;
  EXPECT_NE(text.find(", seed 7, hash "), std::string::npos) << text;
  EXPECT_EQ(
      run("return #run:trace 'x' == run.steps, run:trace('time')[run.steps] == run.time, #run:sonar() == run.steps,\n"
          "run:sonar().columns, run:trace('clearance'):min() >= run.clearance_min, run.world == w"),
      "true true true 16 true true");
  EXPECT_EQ(run("local again = new():drive { navigator = home, subgoals = { 'hall', {6, 2}, 'goal' } }\n"
                "return again.hash == run.hash"),
            "true");
}

TEST_F(SimScript, DrivesByNameAndByObject) {
  EXPECT_EQ(run("a = sim:drive { navigator = 'potential_field', subgoals = { {6, 2} }, hand_over = 0.5 }\n"
                "local field = meander.polar.potential_field { robot = 'nomad200' }\n"
                "b = new():drive { navigator = field, subgoals = { {6, 2} }, hand_over = 0.5 }\n"
                "return a.reached, a.hash == b.hash, a.navigator"),
            "1 true potential_field");
  EXPECT_EQ(run("local field = meander.polar.potential_field {}\n"
                "c = new():drive { navigator = function(o, s) return field:step(o, s) end, subgoals = { {6, 2} }, "
                "hand_over = 0.5 }\n"
                "return c.reached, c.length == a.length"),
            "1 true");
}

TEST_F(SimScript, NavigatorsInLuaAreTablesToo) {
  EXPECT_EQ(run("local count = 0\n"
                "local r = sim:drive { navigator = { name = 'mine', step = home, reset = function() count = count + 1 "
                "end },\n"
                "  subgoals = { {3, 1} } }\n"
                "return r.navigator, count, r.reached"),
            "mine 1 1");
  EXPECT_EQ(run("local r = new():drive { navigator = function() return 0, 0, 'trapped', 'no wish' end, subgoals = { "
                "{3, 1} } }\n"
                "return r.success, r.reached, (r.reason:find('no wish')) ~= nil"),
            "false 0 true");
}

TEST_F(SimScript, GuidesInLua) {
  EXPECT_EQ(run("local points, i, statuses = { {3, 1}, {4, 2} }, 1, {}\n"
                "local function guide(o, status)\n"
                "  statuses[status.status] = true\n"
                "  local p = points[i]\n"
                "  if p and (o.pose.x - p[1]) ^ 2 + (o.pose.y - p[2]) ^ 2 < 0.1 then i = i + 1 end\n"
                "  if not points[i] then return true, 'saw everything', i - 1 end\n"
                "  return { x = points[i][1], y = points[i][2], name = 'p' .. i }, nil, i - 1\n"
                "end\n"
                "local r = sim:drive { navigator = home, guide = guide }\n"
                "return r.success, r.reason, r.reached, statuses.driving"),
            "true saw everything 2 true");
  EXPECT_EQ(run("local list = meander.autonomy.subgoal_list { subgoals = { {3, 1} } }\n"
                "local r = new():drive { navigator = home, guide = list } return r.reached, r.guide == list.name"),
            "1 true");
}

TEST_F(SimScript, OnStepWatchesEditsAndEnds) {
  EXPECT_EQ(run("local n = 0\n"
                "local r = sim:drive { navigator = straight, subgoals = { {10, 1} }, on_step = function(s)\n"
                "  assert(rawequal(s, sim)) n = n + 1\n"
                "  if n == 3 then s.world:add_box { center = {3, 1}, size = {0.2, 0.2}, name = 'surprise' } end\n"
                "  return n < 5\n"
                "end }\n"
                "return n, r.cycles, w:get('surprise').kind"),
            "5 5 obstacle");
}

TEST_F(SimScript, SeveralRobotsDriveTogether) {
  EXPECT_EQ(run("local s = meander.sim.new { world = w, robots = { { start = {1, 1, 0} }, { start = {1, 5, 0}, robot = "
                "'scout' } } }\n"
                "local runs = s:drive { pilots = { { navigator = home, subgoals = { {3, 1} } },\n"
                "  { navigator = home, subgoals = { {3, 5} } } } }\n"
                "s:step { {0, 0}, { v = 0, w = 0 } }\n"
                "return #runs, runs[1].reached, runs[2].reached, s.robots[2].platform, #s.robots"),
            "2 1 1 scout 2");
}

TEST_F(SimScript, ErrorsInCallbacksKeepTheirPlace) {
  EXPECT_EQ(run("sim:drive { navigator = function(o, s)\n error('mine') end, subgoals = { {3, 1} } }"),
            "error: test:2: mine");
  EXPECT_EQ(
      run("sim:drive { navigator = function(o, s)\n return o.sonra[1], 0 end, subgoals = { {3, 1} } }").substr(0, 73),
      "error: test:2: observation: has no member 'sonra'; did you mean 'sonar'? ");
  EXPECT_EQ(
      run("sim:drive { navigator = function(o, s) return 'fast' end, subgoals = { {3, 1} } }"),
      "error: test:1: sim:drive: option 'navigator': result: two numbers v, w expected, got string \"fast\", nil");
  EXPECT_EQ(run("sim:drive { navigator = function(o, s) return 0/0, 0 end, subgoals = { {3, 1} } }"),
            "error: test:1: sim:drive: option 'navigator': result: finite number expected, got number nan");
  EXPECT_EQ(
      run("sim:drive { navigator = function() return 0, 0, 'traped' end, subgoals = { {3, 1} } }"),
      "error: test:1: sim:drive: option 'navigator': result: unknown value 'traped', one of 'driving', 'arrived', "
      "'trapped'; did you mean 'trapped'?");
  EXPECT_EQ(run("sim:drive { navigator = home, guide = function() return 3 end }").substr(0, 54),
            "error: test:1: sim:drive: option 'guide': result: plac");
}

TEST_F(SimScript, MessagesOfTheCommonMistakes) {
  std::string navigators;
  for (const std::string& name : navigator_names()) navigators += (navigators.empty() ? "'" : ", '") + name + "'";
  const std::pair<const char*, std::string> cases[] = {
      {"meander.sim.new { world = w, sede = 3 }",
       "1: meander.sim.new: unknown option 'sede'; did you mean 'seed'? (known: world, robot, sonar, drift, whisker, "
       "light, start, "
       "robots, seed, period, period_jitter, command_delay)"},
      {"meander.sim.new {}", "1: meander.sim.new: option 'world': missing, world expected"},
      {"meander.sim.new { world = 'office' }",
       "1: meander.sim.new: option 'world': world expected, got string \"office\""},
      {"new { robot = 'nomad' }",
       "8: meander.sim.new: option 'robot': unknown value 'nomad', one of 'nomad200', 'scout', 'alice'; did "
       "you mean 'nomad200'?"},
      {"new { seed = -1 }", "8: meander.sim.new: option 'seed': an integer from 0 on expected, got -1"},
      {"new { drift = { veeer = 1 } }",
       "8: meander.sim.new: unknown option 'drift.veeer'; did you mean 'veer'? (known: distance_bias, turn_bias, veer, "
       "distance_noise, turn_noise, veer_noise, slip, slip_spread, slip_length, preset)"},
      {"new { sonar = { preset = 'nomad', noise = -1 } }",
       "8: meander.sim.new: option 'sonar.noise': a number from 0 to 10 [m] expected, got -1"},
      {"new { robot = { body = { radius = 'big' } } }",
       "8: meander.sim.new: option 'robot.body.radius': number expected, got string \"big\""},
      {"new { start = {0/0, 1, 0} }", "8: meander.sim.new: option 'start': {x, y, heading} expected, got {nan, 1, 0}"},
      {"new { start = {0.05, 1, 0} }",
       "8: meander.sim.new: start (0.05, 1.00) is 0.050 m from obstacle 'rim'; at least the robot's radius 0.267 m "
       "expected"},
      {"new { start = 'hal' }", "8: meander.sim.new: no 'hal' in this world; did you mean 'hall'?"},
      {"sim:drive { navigator = 'potential_feld', subgoals = { 'hall' } }",
       "1: sim:drive: option 'navigator': unknown value 'potential_feld', one of " + navigators +
           "; did you mean "
           "'potential_field'?"},
      {"sim:drive { navigator = home, subgoals = { 'hal' } }",
       "1: sim:drive: no 'hal' in this world; did you mean 'hall'?"},
      {"sim:drive { navigator = home, subgoals = { 'rim' } }",
       "1: sim:drive: option 'subgoals': a place or {x, y} expected, got obstacle 'rim'"},
      {"sim:drive { navigator = home }",
       "1: sim:drive: option 'subgoals': missing, a list of places or points expected"},
      {"sim:drive { subgoals = { 'hall' } }",
       "1: sim:drive: option 'navigator': missing, name, navigator, function(observation, subgoal) or table of "
       "functions "
       "expected"},
      {"sim.drive { navigator = home, subgoals = { 'hall' } }",
       "1: sim:drive: self: sim expected, got table {navigator = ..., subgoals = ...} (call it with ':')"},
      {"sim:step()",
       "1: sim:step: argument 1 ('command'): number, {v =, w =} or list of {v =, w =} expected, got nothing"},
      {"sim:step { v = 1, omega = 2 }", "1: sim:step: unknown option 'omega' (known: v, w, vy)"},
      {"sim:step { {1, 0}, {1, 0} }", "1: sim:step: 1 command expected, one per robot, got 2"},
      {"sim:drive { navigator = home, subgoals = { {1e9, 0/0} } }",
       "1: sim:drive: option 'subgoals[1]': {x, y} expected, got {1000000000, nan}"},
  };
  for (const auto& [script, message] : cases) EXPECT_EQ(run(script), std::string("error: test:") + message) << script;
}

TEST_F(SimScript, ChecksTheKeysOfPoints) {
  const std::pair<const char*, const char*> cases[] = {
      {"{3, 1, tolerence = 0.1}",
       "unknown option 'subgoals[1].tolerence'; did you mean 'tolerance'? (known: tolerance, "
       "heading, name)"},
      {"{3, 1, tolerance = -1}", "option 'subgoals[1].tolerance': a number from 0 to 1000000 [m] expected, got -1"},
      {"{3, 1, heading = 1e300}",
       "option 'subgoals[1].heading': a number from -1000000 to 1000000 [rad] expected, got 1e+300"},
      {"{x = 3, y = 1, heading = 1e300}",
       "option 'subgoals[1].heading': a number from -1000000 to 1000000 [rad] expected, got 1e+300"},
      {"{3, 1, name = 7}", "option 'subgoals[1].name': string expected, got number 7"},
      {"{3, 1, [true] = 7}", "options by name expected, got number 7 without a name (known: tolerance, heading, name)"},
  };
  for (const auto& [point, message] : cases)
    EXPECT_EQ(run(std::string("sim:drive { navigator = home, subgoals = { ") + point + " } }"),
              std::string("error: test:1: sim:drive: ") + message);
  EXPECT_EQ(run("return sim:drive { navigator = home, subgoals = { {3, 1, name = 'desk'} } }.goals[1].name"), "desk");
  EXPECT_EQ(run("return new():drive { navigator = home, subgoals = { sim.pose } }.reached"), "1");
  EXPECT_EQ(run("new():drive { navigator = home, guide = function() return {3, 1, tolerance = -1} end }"),
            "error: test:1: sim:drive: option 'guide.tolerance': a number from 0 to 1000000 [m] expected, got -1");
  EXPECT_EQ(run("return new():drive { navigator = home, guide = function() end }.reason"),
            "the guide finished without a reason");
}

TEST_F(SimScript, NavigatorsAndGuidesServeOneRunAtATime) {
  run("field = meander.polar.potential_field {}\n"
      "list = meander.autonomy.subgoal_list { subgoals = { {3, 1} } }\n"
      "other = meander.world.new { bounds = {{0, 0}, {9, 9}}, start = {1, 1, 0} }\n"
      "function second(more) more.time_limit = 1 return meander.sim.new { world = other }:drive(more) end");
  const std::string at_work = " is at work; functions that it calls may look at it, but not drive it";
  EXPECT_EQ(run("sim:drive { navigator = field, subgoals = { {3, 1} }, on_step = function()\n"
                "second { navigator = field, subgoals = { {3, 1} } } end }"),
            "error: test:4: sim:drive: the navigator" + at_work);
  EXPECT_EQ(run("new():drive { navigator = field, guide = list, on_step = function()\n"
                "second { navigator = home, guide = list } end }"),
            "error: test:4: sim:drive: the guide" + at_work);
  EXPECT_EQ(run("new():drive { navigator = field, guide = list, on_step = function() list:reset() end }"),
            "error: test:1: guide:reset: the guide" + at_work);
  EXPECT_EQ(run("new():drive { navigator = field, guide = list, on_step = function() field:reset() end }"),
            "error: test:1: navigator:reset: the navigator" + at_work);
  EXPECT_EQ(run("local s = meander.sim.new { world = w, robots = { {}, { start = {1, 5, 0} } } }\n"
                "s:drive { pilots = { { navigator = field, subgoals = { {3, 1} } },\n"
                "  { navigator = field, subgoals = { {3, 5} } } } }"),
            "error: test:2: sim:drive: option 'pilots': each needs a navigator of its own");
  EXPECT_EQ(run("return new():drive { navigator = field, guide = list }.reached"), "1");
}

TEST_F(SimScript, OneRobotOrSeveral) {
  EXPECT_EQ(run("sim:drive { navigator = home, pilots = { { navigator = home, subgoals = { {3, 1} } } } }"),
            "error: test:1: sim:drive: options 'pilots' and 'navigator': one of them expected, got both");
  EXPECT_EQ(run("sim:drive { subgoals = { {3, 1} }, pilots = { { navigator = home, subgoals = { {3, 1} } } } }"),
            "error: test:1: sim:drive: options 'pilots' and 'subgoals': one of them expected, got both");
  EXPECT_EQ(run("sim:drive { pilots = {} }"),
            "error: test:1: sim:drive: option 'pilots': one table per robot expected, got {}");
  EXPECT_EQ(run("new { robots = {} }"),
            "error: test:8: meander.sim.new: option 'robots': at least one table of options expected, got {}");
}

TEST_F(SimScript, CallbacksMayLookButNotDrive) {
  for (const char* call : {"sim:reset()", "sim:step(0, 0)", "sim:drive { navigator = home, subgoals = { {3, 1} } }"}) {
    const std::string name = std::string(call).substr(0, std::string(call).find_first_of("( "));
    const std::string message =
        "error: test:1: " + name + ": the sim is at work; functions that it calls may look at it, but not drive it";
    EXPECT_EQ(run("sim:drive { navigator = home, guide = function() " + std::string(call) + " return {3, 1} end }"),
              message);
    EXPECT_EQ(run("sim:drive { navigator = function() " + std::string(call) + " end, subgoals = { {3, 1} } }"),
              message);
    EXPECT_EQ(run("sim:drive { navigator = home, subgoals = { {3, 1} }, on_step = function() " + std::string(call) +
                  " end }"),
              message);
  }
  EXPECT_EQ(run("local other sim:drive { navigator = home, subgoals = { {3, 1} }, on_step = function(s)\n"
                "  other = s:fork() other:step(0.1, 0) return false end }\n"
                "sim:reset() return other.time > sim.time"),
            "true");
}

TEST_F(SimScript, StopsInTheMiddleOfADrive) {
  EXPECT_EQ(run("stop_at = 20 n = 0"), "");
  lua_pushlightuserdata(L, &session_.stop);
  lua_pushcclosure(
      L,
      [](lua_State* state) {
        static_cast<StopToken*>(lua_touserdata(state, lua_upvalueindex(1)))->request();
        return 0;
      },
      1);
  lua_setglobal(L, "stop");
  EXPECT_EQ(run("sim:drive { navigator = home, subgoals = { {11, 8} }, on_step = function() n = n + 1 if n == 20 then "
                "stop() end end }"),
            "error: interrupted");
  session_.stop.clear();
  EXPECT_EQ(run("return n, sim.time > 0, sim:step(0, 0).time > 0"), "20 true true");
}

TEST_F(SimScript, SavesAndShows) {
  EXPECT_EQ(run("run = sim:drive { navigator = home, subgoals = { {3, 1} } }\n"
                "for _, suffix in ipairs { '.svg', '.csv', '.jsonl' } do\n"
                "  local path = os.tmpname() .. suffix run:save(path)\n"
                "  local f <close> = assert(io.open(path)) assert(#f:read 'a' > 100, suffix) os.remove(path)\n"
                "end\n"
                "return run:to_json():sub(1, 1)"),
            "{");
  EXPECT_EQ(run("run:save 'x.mp4'"),
            "error: test:1: run:save: x.mp4: unknown suffix, .svg, .png, .csv or .jsonl expected");
  std::string shown;
  session_.write = [&](std::string_view text) { shown += text; };
  EXPECT_EQ(run("show(run) show(sim) show(w)"), "");
  EXPECT_GT(shown.size(), 300u);
  EXPECT_EQ(run("show(3)"),
            "error: test:1: show: something that can be seen expected (a world, a sim, a run, a reading, numbers), got "
            "number 3");
}

TEST_F(SimScript, CollectingInBetweenChangesNothing) {
  EXPECT_EQ(
      run("collectgarbage('generational') collectgarbage('incremental', 1, 1000)\n"
          "local first = new():drive { navigator = home, subgoals = { 'hall', 'goal' } }.hash\n"
          "local second = new():drive { navigator = function(o, s) collectgarbage('step') return home(o, s) end,\n"
          "  subgoals = { 'hall', 'goal' }, on_step = function() collectgarbage() end }\n"
          "return first == second.hash"),
      "true");
}

}  // namespace
}  // namespace meander::script

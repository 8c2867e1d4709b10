// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// watch() and what is left of a drive that was cut short. How it looks on a terminal: repl_watch_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

constexpr const char* kOffice =
    "function sim() return meander.sim.new { world = meander.world.open '" MEANDER_SOURCE_DIR
    "/worlds/office.toml', robot = 'nomad200', sonar = 'real', seed = 7 } end "
    "function with(more) local o = { navigator = 'potential_field', subgoals = { 'door_a', 'hall' } } "
    "for k, v in pairs(more or {}) do o[k] = v end return o end ";

class WatchScript : public ScriptState {
 protected:
  WatchScript() {
    bind_all(L);
    session_.write = [this](std::string_view text) { written_ += text; };
    run(kOffice);
  }
  std::string written_;
};

TEST_F(WatchScript, DrivesTheSameRunAsDrive) {
  const std::string code =
      "a = sim():drive(with()) b = watch(sim(), with { speed = 0 }) "
      "return a.hash == b.hash, a.cycles == b.cycles, b.reached";
  EXPECT_EQ(run(code), "true true 2");
  EXPECT_NE(written_.find("@ robot\n"), std::string::npos) << "the last picture, plainly";
  EXPECT_EQ(written_.find('\x1b'), std::string::npos);
  session_.terminal = true;
  EXPECT_EQ(run(code), "true true 2") << "pictures change nothing";
  EXPECT_NE(written_.find("\x1b[?1049h"), std::string::npos);
  EXPECT_EQ(run("return watch(sim(), with { speed = 1000, rate = 100 }).hash == a.hash"), "true");
  EXPECT_EQ(run("return watch(sim(), with { speed = math.huge }).hash == a.hash"), "true");
}

TEST_F(WatchScript, ShowsARunAgainAndReturnsIt) {
  session_.terminal = true;
  EXPECT_EQ(run("r = sim():drive(with()) return watch(r, { speed = 0 }) == r"), "true");
  EXPECT_NE(written_.find("0/2 subgoals"), std::string::npos);
  EXPECT_EQ(run("return watch(r, with {})"),
            "error: test:1: watch: option 'navigator': not for a run, which is over; 'speed' and 'rate' are");
  EXPECT_EQ(run("watch(sim():drive(with { record_every = 0 }))"),
            "error: test:1: watch: the run keeps no steps to show (record_every = 0)");
}

TEST_F(WatchScript, SaysWhatItWants) {
  EXPECT_EQ(run("watch(3)"),
            "error: test:1: watch: a sim (to drive it) or a run (to see it again) expected, got number 3");
  EXPECT_EQ(run("watch(sim(), with { speed = -1 })"),
            "error: test:1: watch: option 'speed': number >= 0 (0 or math.huge: as fast as it "
            "goes) expected, got number -1");
  EXPECT_EQ(run("watch(sim(), with { sped = 1 })").substr(0, 96),
            "error: test:1: watch: unknown option 'sped'; did you mean 'speed'? (known: navigator, subgoals, ");
}

TEST_F(WatchScript, WhatAnExplorerFindsShowsWhileItDrives) {
  run("w = meander.world.new { bounds = { {-2, -2}, {6, 2} }, start = {0, 0, 0} } "
      "w:add_box { center = {2, -1}, size = {0.2, 2} } "
      "function go(hide) local s = meander.sim.new { world = w, seed = 3 } "
      "e = meander.indicator.sonar_explorer { goal = {4, 0} } local g = e:guide() "
      "return watch(s, { navigator = 'polar', guide = hide and function(...) return nil, 'over' end or g, speed = 0 }) "
      "end");
  EXPECT_EQ(run("r = go() return e.ending, r.hash == go().hash, #e:graph() > 1"), "reached true true");
  const std::string shown = std::exchange(written_, {});
  run("go(true)");
  EXPECT_GT(std::count(shown.begin(), shown.end(), 'S'), std::count(written_.begin(), written_.end(), 'S') + 5)
      << shown << "indicators are discs of this letter";
}

TEST_F(WatchScript, SeveralRobotsAreSeenToo) {
  session_.terminal = true;
  EXPECT_EQ(run("s = meander.sim.new { world = meander.world.new { bounds = { {0, 0}, {8, 6} } }, "
                "robots = { { start = {1, 1, 0} }, { start = {1, 4, 0} } } } "
                "p = { navigator = 'potential_field', subgoals = { {3, 1} } } "
                "q = { navigator = 'potential_field', subgoals = { {3, 4} } } "
                "r = watch(s, { pilots = { p, q }, speed = 0 }) return #r, r[1] == s:last_run()[1]"),
            "2 true");
}

TEST_F(WatchScript, TheLastRunIsKeptHoweverADriveEnds) {
  EXPECT_EQ(run("s = sim() return s:last_run()"), "nil");
  EXPECT_EQ(
      run("s:drive(with { on_step = function(s) assert(s:last_run() == nil) if s.time > 5 then error 'x' end end })")
          .substr(0, 6),
      "error:");
  EXPECT_EQ(run("r = s:last_run() return r.reason, r.steps == r.cycles, r.time > 5, r.hash ~= 0"),
            "stopped by an error true true true");
  EXPECT_EQ(run("t = sim() return t:drive(with { time_limit = r.time }).hash == r.hash"), "true")
      << "the same states as a drive of that length";
  session_.stop.request();
  EXPECT_EQ(run("watch(s, with())"), "error: interrupted");
  session_.stop.clear();
  EXPECT_EQ(run("return s:last_run().reason, s:last_run() == s:last_run()"), "interrupted true");
  EXPECT_NE(written_.find("@ robot\n"), std::string::npos) << "the last picture";
  EXPECT_EQ(run("return s:drive(with { time_limit = 3 }) == s:last_run()"), "true");
  EXPECT_EQ(run("return (tostring(s:last_run()):gsub('.*; ', ''))"), "ended: time limit of 3 s");
  EXPECT_EQ(run("return tostring(r):match('ended:.*')"), "ended: stopped by an error");
  EXPECT_EQ(run("return tostring(sim():drive(with())):match('ended:.*')"), "nil");
}

TEST_F(WatchScript, LastRunsDoNotKeepSimulationsAlive) {
  EXPECT_EQ(run("local weak = setmetatable({}, { __mode = 'k' }) "
                "for i = 1, 5 do local s = sim() s:drive(with { time_limit = 1 }) weak[s] = true end "
                "collectgarbage() collectgarbage() return next(weak)"),
            "nil");
}

}  // namespace
}  // namespace meander::script

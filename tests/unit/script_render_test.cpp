// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <fstream>

#include "own_folder.hpp"
#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class RenderScript : public ScriptState {
 protected:
  RenderScript() {
    bind_all(L);
    session_.write = [this](std::string_view text) { written_ += text; };
    run("s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } } "
        "run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } } r = meander.render");
  }
  std::string written_;
};

TEST_F(RenderScript, EverythingThatCanBeSeenIsShown) {
  for (const char* what : {"s", "run", "s.world", "meander.sensor.scan { world = s.world }", "run:trace 'v'",
                           "run:sonar()", "{1, 2, 4}", "r.curve {1, 2}", "{1, 0/0, 3}", "{{1, 2}, {3, 0/0}}",
                           "r.heat_map {{1, 2}, {3, 4}}", "r.histogram {1, 2}", "r.heat_map(run:sonar())"}) {
    written_.clear();
    EXPECT_EQ(run(std::string("show(") + what + ")"), "") << what;
    EXPECT_GT(written_.size(), 50u) << what;
    EXPECT_EQ(run(std::string("return r.text(") + what + ", { columns = 20, rows = 8 }):find '\\n' > 0"), "true")
        << what;
  }
}

TEST_F(RenderScript, WhatHasNoPictureIsSaid) {
  EXPECT_EQ(
      run("r.save(3, 'x.png')"),
      "error: test:1: meander.render.save: something that can be seen expected (a world, a sim, a run, a reading, "
      "numbers), got number 3");
  EXPECT_EQ(run("show {}"), "error: test:1: show: numbers to draw expected, got none");
  EXPECT_EQ(run("show {0/0, 1/0}"), "error: test:1: show: numbers to draw expected, got 2 that are not finite");
  EXPECT_EQ(run("show {{1, 2}, {3}}"), "error: test:1: show: rows of equal length expected, got 2 and 1");
  EXPECT_EQ(run("show(s.observation)"),
            "error: test:1: show: something that can be seen expected (a world, a sim, a run, a reading, numbers), got "
            "observation; its .sonar can be shown");
  EXPECT_EQ(run("show {1, 'x'}").substr(0, 19), "error: test:1: show");
  EXPECT_EQ(run("r.text(s, { hide = {'grit'} })").substr(0, 77),
            "error: test:1: meander.render.text: option 'hide[1]': unknown value 'grit', o");
  EXPECT_EQ(run("r.animate(function() return 3 end)").substr(0, 87),
            "error: test:1: meander.render.animate: something that can be seen expected (a world, a ");
}

TEST_F(RenderScript, SizesAndLayersAreChosen) {
  const std::string path = (own_folder() / "a.png").string();
  run("path = '" + path + "'");
  EXPECT_EQ(run("r.save(s, path, { width = 321, hide = { 'cone', 'echo' } })"), "");
  std::ifstream file(path, std::ios::binary);
  std::string head(24, 0);
  file.read(head.data(), 24);
  EXPECT_EQ(head.substr(1, 3), "PNG");
  EXPECT_EQ(static_cast<unsigned char>(head[18]) * 256 + static_cast<unsigned char>(head[19]), 321);
  EXPECT_EQ(run("return r.text(run):find '@' ~= nil, r.text(run, { hide = { 'robot' } }):find '@'"), "true nil");
  EXPECT_EQ(run("return #r.text(s, { mode = 'truecolor', columns = 30, rows = 9 }) > 500"), "true");
}

TEST_F(RenderScript, AnimateShowsWhatAFunctionReturnsUntilItReturnsNothing) {
  const std::string code = "n = 0 r.animate(function(i) n = i return i < 5 and {1, i} end, { rate = 100 }) return n";
  EXPECT_EQ(run(code), "5");
  EXPECT_EQ(written_.find('\x1b'), std::string::npos);
  EXPECT_NE(written_.find('*'), std::string::npos) << "the last picture";
  session_.terminal = true;
  EXPECT_EQ(run(code), "5");
  EXPECT_NE(written_.find("\x1b[?1049l"), std::string::npos);
  EXPECT_EQ(run("r.animate(function() error 'mine' end)"), "error: test:1: mine");
  session_.stop.request();
  EXPECT_EQ(run("r.animate(function() return s end)"), "error: interrupted");
  session_.stop.clear();
}

TEST_F(RenderScript, PicturesAreObjects) {
  EXPECT_EQ(run("return tostring(r.curve {1, 2}):match '^picture: %d+ items$' ~= nil"), "true");
  EXPECT_EQ(run("return r.text(r.curve({1, 2}, { title = 'error' })):find 'error' ~= nil"), "true");
}

}  // namespace
}  // namespace meander::script

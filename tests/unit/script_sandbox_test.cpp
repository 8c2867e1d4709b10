// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The sandbox of the interpreter alone, without the walls around the process; tests/hostile has those.
#include "script/sandbox_state.hpp"

#include <gtest/gtest.h>
#include <lua.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "script/interpreter.hpp"

namespace meander::script {
namespace {

namespace fs = std::filesystem;

class SandboxTest : public ::testing::Test {
 protected:
  SandboxTest()
      : folder_(fs::temp_directory_path() / ("meander_sandbox_" + std::to_string(getpid()))),
        before_(fs::current_path()) {
    fs::create_directories(folder_ / "box");
    std::ofstream(folder_ / "outside.toml") << "";
    fs::create_symlink("..", folder_ / "box" / "up");
    fs::create_symlink("../outside.toml", folder_ / "box" / "link.toml");
    fs::create_symlink("../made.toml", folder_ / "box" / "dangling.toml");
    mkfifo((folder_ / "box" / "pipe.toml").c_str(), 0600);
    fs::current_path(folder_ / "box");
  }
  ~SandboxTest() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }

  /// The message, or nothing.
  static std::string run(Interpreter& lua, const std::string& code) { return lua.run_text(code, "=test").message; }

  fs::path folder_, before_;
};

const char* const kObjects = R"(
  local w = meander.world.new { start = {1, 1, 0} }
  local s = meander.sim.new { world = w }
  local grid = meander.planning.map { world = w, resolution = 0.5 }
  local room = meander.world.new { bounds = { {0, 0}, {4, 4} } }
  room:add_wall { points = { {0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5} } }
  local lessons = meander.mapping.lessons { worlds = { room }, poses = 20 }
  local places = meander.topology.map {}
  o = { world = w, sim = s, reading = meander.sensor.scan { world = w }, grid_map = grid,
    run = s:drive { navigator = function() return 0.3, 0 end, subgoals = { {2, 1} } },
    map = meander.mapping.map { model = 'elfes' }, indicator_graph = meander.indicator.graph(),
    explorer = meander.indicator.explorer { goal = {5, 5} }, topologic_map = places,
    sonar_explorer = meander.indicator.sonar_explorer { goal = {5, 5} },
    minimal_map = meander.topology.minimal { map = places },
    sonar_network = meander.mapping.train { lessons = lessons, hidden = {2}, epochs = 1 } })";

/// Every function that takes the name of a file, as its record tells, refuses every name that leads out.
TEST_F(SandboxTest, EveryFunctionRefusesFilesOutside) {
  Interpreter lua({.sandbox = SandboxOptions{}});
  ASSERT_EQ(run(lua, kObjects), "");
  int functions = 0;
  for (const Record& record : lua.session().docs.all())
    for (std::size_t at = 0; at < record.arguments.size(); ++at) {
      const std::string& name = record.arguments[at].name;
      if (name != "path" && name != "file" && name != "folder") continue;
      ++functions;
      for (const char* path : {"/etc/passwd", "../outside.toml", "../new.toml", "up/new.toml", "link.toml",
                               "dangling.toml", "pipe.toml", "/proc/self/environ", "x\\0.toml", "/dev/null"}) {
        std::string call = record.kind == DocKind::method ? "o." + record.owner + ":" + record.member : record.name();
        call += "(";
        for (std::size_t i = 0; i < at; ++i) call += "o.world, ";
        const std::string message = run(lua, call + "'" + path + "')");
        EXPECT_NE(message.find("sandbox: '"), std::string::npos) << call << path << ": " << message;
      }
    }
  EXPECT_GE(functions, 16);
  EXPECT_FALSE(fs::exists(folder_ / "new.toml"));
  EXPECT_FALSE(fs::exists(folder_ / "made.toml"));
}

TEST_F(SandboxTest, FilesOfTheFolderAreReadAndWritten) {
  Interpreter lua({.sandbox = SandboxOptions{}});
  EXPECT_EQ(
      run(lua, "local f = io.open('a.txt', 'w') f:write('x', 1) f:close() assert(io.open('a.txt'):read 'a' == 'x1')"),
      "");
  EXPECT_EQ(run(lua, "os.rename('a.txt', 'b.txt') assert(os.remove 'b.txt')"), "");
  EXPECT_EQ(run(lua, "meander.make_folder 'd/e' meander.world.new {}:save 'd/e/w.toml'"), "");
  EXPECT_EQ(run(lua, "assert(meander.world.open 'd/e/w.toml')"), "");
}

TEST_F(SandboxTest, NamesAreMeantInTheFolder) {
  fs::current_path(before_);
  Interpreter lua({.sandbox = SandboxOptions{.folder = (folder_ / "box").string()}});
  EXPECT_EQ(run(lua, "meander.world.new {}:save 'w.toml' assert(meander.world.open 'w.toml')"), "");
  EXPECT_TRUE(fs::exists(folder_ / "box" / "w.toml"));
}

TEST_F(SandboxTest, InstructionsAreCountedToTheLast) {
  for (const char* code : {"while true do end", "pcall(function() while true do end end) while true do end",
                           "coroutine.wrap(function() while true do end end)()"}) {
    Interpreter lua({.sandbox = SandboxOptions{.instructions = 20000}});
    const Outcome outcome = lua.run_text(code, "=test");
    EXPECT_EQ(outcome.kind, Outcome::Kind::failed);
    EXPECT_EQ(outcome.message, "test:1: sandbox: 20000 Lua instructions used up") << code;
    EXPECT_TRUE(lua.ended());
    EXPECT_NE(run(lua, "print 'again'"), "");
  }
}

TEST_F(SandboxTest, InstructionsAreTheSameInEveryRun) {
  const auto rounds = [] {
    Interpreter lua({.sandbox = SandboxOptions{.instructions = 50000}});
    run(lua, "n = 0 while true do n = n + 1 end");
    lua_getglobal(lua.state(), "n");
    return lua_tointeger(lua.state(), -1);
  };
  const lua_Integer first = rounds();
  EXPECT_GT(first, 1000);
  EXPECT_EQ(rounds(), first);
}

TEST_F(SandboxTest, MemoryIsAnErrorOfTheScript) {
  Interpreter lua({.sandbox = SandboxOptions{.memory = 32}});
  EXPECT_NE(
      run(lua, "kept = {} while true do kept[#kept + 1] = ('x'):rep(1000) .. #kept end").find("not enough memory"),
      std::string::npos);
  EXPECT_EQ(run(lua, "kept = nil"), "");
  EXPECT_EQ(run(lua, "local t = {} for i = 1, 1000 do t[i] = ('x'):rep(1000) .. i end"), "");
}

TEST_F(SandboxTest, ExitEndsTheScriptWithItsCode) {
  Interpreter lua({.sandbox = SandboxOptions{}});
  const Outcome outcome = lua.run_text("pcall(os.exit, 3) x = 1", "=test");
  EXPECT_EQ(outcome.exit_code, 3);
  lua_getglobal(lua.state(), "x");
  EXPECT_TRUE(lua_isnil(lua.state(), -1));
}

TEST_F(SandboxTest, FunctionsThatWereDroppedAreNamed) {
  Interpreter lua({.sandbox = SandboxOptions{}});
  EXPECT_EQ(run(lua, "os.execute 'ls'"), "test:1: the sandbox has no os.execute");
  EXPECT_EQ(run(lua, "local s = ('x').dump"), "test:1: the sandbox has no string.dump");
  EXPECT_EQ(run(lua, "local f = io.stdin"), "test:1: the sandbox has no io.stdin");
  EXPECT_EQ(run(lua, "assert(os.exec == nil and math.foo == nil and os[1] == nil)"), "");
  EXPECT_EQ(run(lua, "assert(rawget(os, 'execute') == nil and getmetatable(os) == 'locked')"), "");
}

TEST_F(SandboxTest, WordsThatAreShownAgainCommandNoTerminal) {
  Interpreter lua({.sandbox = SandboxOptions{}});
  std::string written;
  lua.session().write = [&](std::string_view text) { written += text; };
  EXPECT_EQ(run(lua, R"(apropos '\27[2J')"), "");
  EXPECT_EQ(written, "nothing is known about '\\27[2J'\n");
}

TEST_F(SandboxTest, AFolderThatIsNoneIsAnError) {
  EXPECT_THROW(Interpreter({.sandbox = SandboxOptions{.folder = "nowhere"}}), Error);
}

}  // namespace
}  // namespace meander::script

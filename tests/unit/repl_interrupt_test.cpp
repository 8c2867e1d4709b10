// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>
#include <lauxlib.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string_view>

#include "base/random.hpp"
#include "repl/prompt.hpp"
#include "repl_pty.hpp"
#include "script/interpreter.hpp"

namespace meander::test {
namespace {

/// A computation in C++ that ends only when it is stopped, with the border every binding has.
int compute_for_ever(lua_State* L) {
  const Work work = script::work_of(L);
  try {
    for (;;) work.poll();
  } catch (const Cancelled&) {
    // the error is raised outside of the handler
  }
  return luaL_error(L, script::kInterrupted);
}

/// One that cannot be stopped, as a single call into the C library may be.
int deaf(lua_State*) {
  std::puts("begun");
  std::fflush(stdout);
  for (;;) pause();
}

int prompt_with_long_call() {
  script::Interpreter lua;
  lua_pushcfunction(lua.state(), deaf);
  lua_setglobal(lua.state(), "deaf");
  lua_pushcfunction(lua.state(), compute_for_ever);
  lua_setglobal(lua.state(), "compute_for_ever");
  return repl::run_prompt(lua, {.version = "test", .start_up = false});
}

struct Endless {
  const char* name;
  const char* code;
};

/// A simulation whose robot cannot get anywhere, but tries.
constexpr const char* kWalledIn =
    "function parked() local w = world.new { bounds = {{0, 0}, {10, 10}}, start = {2, 2, 0} } "
    "w:add_box { center = {5, 5}, size = {0.2, 9.9} } return sim.new { world = w } end";
/// A picture that takes long to trace: every pixel by chance.
void write_noise(const std::string& path) {
  constexpr int kSide = 2000;
  Stream random(1, "noise");
  std::string pixels(static_cast<std::size_t>(kSide) * kSide, '\0');
  for (char& pixel : pixels) pixel = random.below(2) ? '\xff' : '\0';
  std::ofstream(path, std::ios::binary) << "P5 " << kSide << ' ' << kSide << " 255\n" << pixels;
}

class Interrupt : public testing::TestWithParam<Endless> {};

TEST_P(Interrupt, ReturnsToThePromptWithTheStateKept) {
  TemporaryFolder home;
  Terminal t(home.path(), prompt_with_long_call);
  t.wait_for("> ");
  t.enter("kept = 41 function endless() while true do end end");
  t.enter(kWalledIn);
  t.enter("sample = {} for i = 1, 100000 do sample[i] = i end");
  if (std::string_view(GetParam().name) == "Import") write_noise(home / "noise.pgm");
  for (int round = 0; round < 2; ++round) {
    t.send(std::string("print 'begun' ") + GetParam().code + "\r");
    t.wait_for("begun\r\n");
    const auto pressed = std::chrono::steady_clock::now();
    t.send("\x03");
    t.wait_for("interrupted\r\n> ");
    const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - pressed;
    RecordProperty("milliseconds", std::to_string(waited.count()));
    EXPECT_EQ(t.enter("kept + 1"), "42\r\n");
    EXPECT_EQ(t.enter("for i = 1, 1000 do kept = kept end return coroutine.wrap(function() return 1 end)()"), "1\r\n");
  }
}

constexpr Endless kEndless[] = {
    {"LuaLoop", "while true do end"},
    {"Pcall", "while true do pcall(endless) end"},
    {"Xpcall", "while true do xpcall(endless, function(e) return e end) end"},
    {"Coroutine", "coroutine.wrap(endless)()"},
    {"CoroutineResumedInALoop", "while true do coroutine.resume(coroutine.create(endless)) end"},
    {"CoroutineThatYields",
     "c = coroutine.wrap(function() while true do coroutine.yield() end end) while true do c() end"},
    {"CoroutineInACoroutine", "coroutine.wrap(function() while true do pcall(coroutine.wrap(endless)) end end)()"},
    {"CoroutineThatIsClosed",
     "c = coroutine.create(function() local v <close> = setmetatable({}, {__close = endless}) coroutine.yield() end) "
     "coroutine.resume(c) coroutine.close(c)"},
    {"TableSort", "while true do pcall(table.sort, {3, 1, 2}, function(a, b) endless() end) end"},
    {"StringGsub", "while true do (('a'):rep(100)):gsub('a', endless) end"},
    {"Metamethod", "return setmetatable({}, {__index = endless}).x"},
    {"PrettyPrinter", "return setmetatable({}, {__tostring = endless})"},
    {"NativeCall", "compute_for_ever()"},
    {"NativeCallInPcall", "while true do pcall(compute_for_ever) end"},
    {"NativeCallInACoroutine", "while true do coroutine.resume(coroutine.create(compute_for_ever)) end"},
    {"Drive",
     "parked():drive { navigator = 'potential_field', subgoals = {{9, 9}}, time_limit = 1e9, when_trapped = 'insist' "
     "}"},
    {"DriveByLua",
     "parked():drive { navigator = function() return 0, 0 end, subgoals = {{9, 9}}, time_limit = 1e9, record_every = 0 "
     "}"},
    {"DriveInPcall", "while true do pcall(parked().drive, parked(), { navigator = endless, subgoals = {{9, 9}} }) end"},
    {"Trials", "study.trials { count = 1000000, trial = function() return 1 end }"},
    {"EndlessTrial", "study.trials { count = 2, trial = endless }"},
    {"Bootstrap", "study.bootstrap_mean(sample, { resamples = 1000000 })"},
    {"Import", "while true do pcall(world.import, 'noise.pgm', { resolution = 0.05 }) end"},
};

INSTANTIATE_TEST_SUITE_P(, Interrupt, testing::ValuesIn(kEndless),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SecondInterrupt, EndsTheProgramAndRestoresTheTerminal) {
  TemporaryFolder home;
  Terminal t(home.path(), prompt_with_long_call);
  t.wait_for("> ");
  EXPECT_FALSE(t.is_cooked());
  t.send("deaf()\r");
  t.wait_for("begun\r\n");
  EXPECT_EQ(t.interrupt_until_exit(), 130);
  EXPECT_TRUE(t.transcript().ends_with("\r\ninterrupted twice: left at once\r\n")) << t.transcript();
  EXPECT_TRUE(t.is_cooked());
}

TEST(BatchInterrupt, ExitsWith130) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"-e", "print 'begun' while true do pcall(function() while true do end end) end"}));
  t.wait_for("begun\r\n");
  t.send("\x03");
  EXPECT_EQ(t.wait_for_exit(), 130);
  EXPECT_TRUE(t.transcript().ends_with("meander: -e:1: interrupted\r\n"));
}

}  // namespace
}  // namespace meander::test

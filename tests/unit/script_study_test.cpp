// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>
#include <unistd.h>

#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

class StudyScript : public ScriptState {
 protected:
  StudyScript() {
    bind_all(L);
    run("function trials(o) return meander.study.trials(o) end");
  }
};

TEST_F(StudyScript, TrialsComeInSeedOrderForAnyNumberOfJobs) {
  for (const char* jobs : {"1", "2", "0"})
    EXPECT_EQ(run(std::string("local r = trials { seeds = {3, 1, 2}, jobs = ") + jobs +
                  ", trial = function(seed, i) return { twice = 2 * seed, i = i, nan = 0/0, list = {1, 2.5, 'x', true} "
                  "} end }\n"
                  "return #r, r[1].seed, r[1].value.twice, r[2].value.i, math.type(r[2].value.i), r[3].value.list[2],\n"
                  "r[3].value.nan ~= r[3].value.nan, r[3].ok"),
              "3 3 6 2 integer 2.5 true true")
        << jobs;
}

TEST_F(StudyScript, RunsBecomeTheirFigures) {
  EXPECT_EQ(run("local function trial(seed)\n"
                "  local w = meander.world.new { start = {2, 2, 0} }\n"
                "  local s = meander.sim.new { world = w, seed = seed }\n"
                "  return s:drive { navigator = function() return 0.3, 0 end, subgoals = { {3, 2} } }\n"
                "end\n"
                "local a = trials { count = 3, seed = 9, jobs = 1, trial = trial }\n"
                "local b = trials { count = 3, seed = 9, jobs = 2, trial = trial }\n"
                "return a[1].value.reached, a[1].value.hash == b[1].value.hash, a[2].value.hash == a[1].value.hash,\n"
                "#a[1].value.hash, a[1].seed > 0, a[1].seed == b[1].seed"),
            "1 true false 16 true true");
}

TEST_F(StudyScript, AFailedTrialIsAResult) {
  EXPECT_EQ(run("local r = trials { seeds = {1, 2, 3}, jobs = 2, trial = function(seed)\n"
                "  if seed == 2 then error('mine') end return seed end }\n"
                "return r[1].value, r[2].ok, r[2].error, r[3].value"),
            "1 false test:2: mine 3");
  EXPECT_EQ(
      run("local r = trials { seeds = {1}, jobs = 1, trial = function() return print end } return r[1].ok, r[1].error"),
      "false results of numbers, texts, booleans, tables or runs expected, got function");
  EXPECT_EQ(run("local t = {} t.t = t local r = trials { seeds = {1}, jobs = 1, trial = function() return t end }\n"
                "return r[1].error"),
            "results nested at most 64 tables deep expected");
}

TEST_F(StudyScript, ErrorsThatAreNoTextStayInTheTrial) {
  const pid_t parent = getpid();
  const std::string result =
      run("local r = trials { count = 5, jobs = 2, trial = function(_, i)\n"
          "  if i == 1 then error(setmetatable({}, { __tostring = function() error 'inner' end })) end\n"
          "  if i == 2 then error(setmetatable({}, { __tostring = function() return 'outer' end })) end\n"
          "  if i == 3 then error {} end\n"
          "  if i == 4 then error() end\n"
          "  return i end }\n"
          "return r[1].error, r[2].error, r[3].error, r[4].error, r[5].value");
  if (getpid() != parent) _exit(9);
  EXPECT_EQ(result, "test:2: inner outer error value is a table, not a text error without a message 5");
}

TEST_F(StudyScript, TheNumberOfJobsChangesNothing) {
  std::string first;
  for (const char* jobs : {"1", "2", "7"}) {
    const std::string result =
        run("calls = 0 local up = 0\n"
            "local r = trials { count = 9, jobs = " +
            std::string(jobs) +
            ", trial = function(seed, i)\n"
            "  calls, up = calls + 1, up + i\n"
            "  return table.concat({ calls, up, math.random(1000000), math.random() }, ' ') end }\n"
            "local all = {} for i, t in ipairs(r) do all[i] = t.value end\n"
            "return calls, up, all[1] ~= all[2], table.concat(all, ';')");
    EXPECT_TRUE(result.starts_with("0 0 true 1 1 ")) << result;
    if (first.empty()) first = result;
    EXPECT_EQ(result, first) << jobs;
  }
  EXPECT_EQ(run("local r = trials { seeds = {7}, trial = function() return math.random() end }\n"
                "math.randomseed(7) return r[1].value == math.random()"),
            "true");
}

TEST_F(StudyScript, TablesThatCannotBeCarriedAreRefused) {
  const auto error_of = [&](const std::string& value) {
    return run("local r = trials { seeds = {1}, trial = function() return " + value +
               " end }\nreturn r[1].ok, r[1].error");
  };
  const std::string keys = "false results with keys that are strings or 1 to n expected, got the key ";
  EXPECT_EQ(error_of("{1, 2, [10] = 5}"), keys + "number 10");
  EXPECT_EQ(error_of("{1, 2, [0] = 7}"), keys + "number 0");
  EXPECT_EQ(error_of("{[-1] = 7}"), keys + "number -1");
  EXPECT_EQ(error_of("{1, [1.5] = 7}"), keys + "number 1.5");
  EXPECT_EQ(error_of("{1, 2, x = 3}"), "false results that are lists or have keys by name expected, got both in one");
}

TEST_F(StudyScript, JsonRefusesWhatItCannotCarry) {
  run("json = dofile '" MEANDER_SOURCE_DIR "/lua/json.lua'");
  EXPECT_EQ(run("return json.encode({1, 2, {x = 3}}), json.encode {}"), "[1,2,{\"x\":3}] []");
  EXPECT_EQ(run("return json.encode {1, 2, x = 3}"),
            "error: json.encode: list with a key 'x'; only 1..n or only strings expected");
  EXPECT_EQ(run("return json.encode {1, 2, [10] = 3}"),
            "error: json.encode: list with a key '10'; only 1..n or only strings expected");
}

TEST_F(StudyScript, OnlyTheCallerShowsProgress) {
  const pid_t parent = getpid();
  std::string labels;
  session_.progress = [&](double, std::string_view label) {
    if (getpid() != parent) _exit(9);
    labels += std::string(label) + " ";
  };
  EXPECT_EQ(run("local function inner() return trials { count = 2, trial = function() return 1 end }[2].value end\n"
                "local r = trials { count = 3, jobs = 2, trial = inner }\n"
                "return r[1].ok, r[2].value, r[3].value"),
            "true 1 1");
  EXPECT_EQ(labels, "trials trials trials ");
}

TEST_F(StudyScript, Statistics) {
  EXPECT_EQ(run("return meander.study.mean {1, 2, 6}, meander.study.median {1, 2, 6}, "
                "meander.study.mean(meander.numbers {1, 3})"),
            "3.0 2.0 2.0");
  EXPECT_EQ(run("local p, low, high = meander.study.wilson(18, 20) return p, ('%.4f %.4f'):format(low, high)"),
            "0.9 0.6990 0.9721");
  EXPECT_EQ(run("local m, low, high = meander.study.bootstrap_mean({1, 2, 6}, { seed = 3 })\n"
                "local again = select(2, meander.study.bootstrap_mean({1, 2, 6}, { seed = 3 }))\n"
                "return m, low < m and m < high, low == again, (meander.study.bootstrap_median {1, 2, 6})"),
            "3.0 true true 2.0");
  EXPECT_EQ(run("return select(4, meander.study.compare({1, 2, 6}, {2, 2, 3}))"), "1 1 1");
  EXPECT_TRUE(run("meander.study.wilson(3, 2)").starts_with("error: test:1: meander.study.wilson: "));
  EXPECT_EQ(run("trials { trial = print }"),
            "error: test:1: meander.study.trials: options 'seeds' and 'count': one of them expected, got none");
}

TEST_F(StudyScript, ViewsOfNumbers) {
  EXPECT_EQ(run("n = meander.numbers {3, 1, 2} return #n, n[1], n[4], n, n:sum(), n:mean(), n:min()"),
            "3 3.0 nil {3, 1, 2} 6.0 2.0 1.0 2");
  EXPECT_EQ(run("return n:max(), n:slice(2), n:slice(-2, -1), n:slice(1, 3, 2), n:slice(9), #n:slice(3, 1)"),
            "3.0 {1, 2} {1, 2} {3, 2} {} 0");
  EXPECT_EQ(run("local s = 0 for i, v in ipairs(n) do s = s + i * v end\n"
                "return s, table.concat(n:map(function(v, i) return v * i end), ' '), #n:totable()"),
            "11.0 3.0 2.0 6.0 3");
  EXPECT_EQ(run("return table.concat(n:map(function(v) return ('%.2f'):format(v) end), ' ')"), "3.00 1.00 2.00");
  EXPECT_EQ(run("n:map(3)"), "error: test:1: numbers:map: argument 1 ('function'): function expected, got number 3");
  EXPECT_EQ(run("return meander.numbers({}):min(), meander.numbers({}):mean()"), "nil nil");
  EXPECT_EQ(run("m = meander.matrix { {1, 2}, {3, 4} } return m, #m, m[2], m[3], m:column(2), m:all(), m.columns, "
                "m:totable()[2][1]"),
            "matrix: 2 x 2 2 {3, 4} nil {2, 4} {1, 2, 3, 4} 2 3.0");
  EXPECT_EQ(run("m:column(3)"), "error: test:1: matrix:column: there are columns 1 to 2, got 3");
}

}  // namespace
}  // namespace meander::script

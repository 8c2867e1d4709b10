// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lualib.h>

#include <algorithm>
#include <thread>

#include "script/bind.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_options.hpp"
#include "script/lua_traceback.hpp"
#include "script/pack.hpp"
#include "script/sandbox_state.hpp"
#include "script/values.hpp"
#include "study/statistics.hpp"
#include "study/trials.hpp"

namespace meander::script {

struct TrialsTable {
  Required<Function> trial;
  std::vector<std::uint64_t> seeds;
  int count = 0;
  std::uint64_t seed = 1;
  int jobs = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TrialsTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"trial", "", "function(seed, index) that returns a run, or a table, number or text"}, o.trial);
  visit(Field{"seeds", "", "one trial for each"}, o.seeds);
  visit(Field{"count", "", "so many trials, with seeds that follow from `seed`", 0, 1e6}, o.count);
  visit(Field{"seed", "", "from which the seeds of the trials follow"}, o.seed);
  visit(Field{"jobs", "", "trials at a time, each in a process of its own; 0: one per core", 0, 1024}, o.jobs);
}

struct IntervalOptions {
  double confidence = 0.95;
  int resamples = 2000;
  std::uint64_t seed = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, IntervalOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"confidence", "", "with which the interval holds the true value", 0.01, 0.9999}, o.confidence);
  visit(Field{"resamples", "", "samples drawn", 10, 1e7}, o.resamples);
  visit(Field{"seed", "", "seed of the draws"}, o.seed);
}

namespace {

std::vector<std::uint64_t> seeds_of(const TrialsTable& table) {
  if (table.seeds.empty() == (table.count == 0))
    fail("options 'seeds' and 'count': one of them expected, got {}", table.count ? "both" : "none");
  std::vector<std::uint64_t> seeds = table.seeds;
  // Without the top bit, so that Lua shows them as positive numbers.
  for (int i = 0; i < table.count; ++i) seeds.push_back(trial_seed(table.seed, static_cast<std::uint64_t>(i)) >> 1);
  return seeds;
}

void seed_math_random(lua_State* L, std::uint64_t seed) {
  lua_getfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_getfield(L, -1, LUA_MATHLIBNAME);
  lua_getfield(L, -1, "randomseed");
  lua_pushinteger(L, static_cast<lua_Integer>(seed));
  lua_call(L, 1, 0);
  lua_pop(L, 2);
}

struct TrialCall {
  const Function& trial;
  std::uint64_t seed;
  std::size_t index;
  std::string bytes;  ///< the result
};

/// All of a trial that can raise a Lua error; argument 1 is its TrialCall.
int call_trial(lua_State* L) {
  auto& call = *static_cast<TrialCall*>(lua_touserdata(L, 1));
  seed_math_random(L, call.seed);
  call.trial.push();
  push(L, call.seed);
  push(L, static_cast<int>(call.index) + 1);
  lua_call(L, 2, 1);
  std::string problem;
  try {
    call.bytes = pack(L, -1);
    return 0;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  push(L, problem);
  return lua_error(L);
}

/// One trial in its process: the result as bytes. Lua's error becomes an exception, which a worker can report.
std::string run_trial(lua_State* L, const Function& trial, std::uint64_t seed, std::size_t index, int jobs) {
  if (const auto& sandbox = session(L).sandbox) sandbox->become_worker(jobs);
  session(L).progress = nullptr;  // the line of the terminal is the parent's
  TrialCall call{trial, seed, index, {}};
  luaL_checkstack(L, 4, nullptr);
  lua_pushcfunction(L, call_trial);
  lua_pushlightuserdata(L, &call);
  if (ErrorReport report; !call_reporting(L, 1, report)) throw Error(report.message);
  return std::move(call.bytes);
}

void push_trial(lua_State* L, const TrialResult& result, std::uint64_t seed) {
  lua_createtable(L, 0, 3);
  push(L, seed);
  lua_setfield(L, -2, "seed");
  push(L, result.ok);
  lua_setfield(L, -2, "ok");
  if (result.ok)
    unpack(L, result.text);
  else
    push(L, result.text);
  lua_setfield(L, -2, result.ok ? "value" : "error");
}

/// A sandbox is shared by its workers: no more of them than cores, and none of their own.
int jobs_of(const TrialsTable& table, const Sandbox* sandbox) {
  if (!sandbox) return table.jobs;
  if (sandbox->is_worker()) fail<Error>("sandbox: a trial cannot run trials of its own");
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return table.jobs > 0 ? std::min(table.jobs, cores) : cores;
}

Pushed trials(const TrialsTable& table, const Call& call) {
  const int jobs = jobs_of(table, session(call.L).sandbox.get());
  const std::vector<std::uint64_t> seeds = seeds_of(table);
  lua_State* L = call.L;
  lua_createtable(L, static_cast<int>(seeds.size()), 0);
  const int list = lua_gettop(L);
  run_trials(
      seeds.size(), jobs, call.work(),
      [&](std::size_t i) { return run_trial(L, table.trial.value, seeds[i], i, jobs); },
      [&](const TrialResult& result) {
        push_trial(L, result, seeds[result.index]);
        lua_rawseti(L, list, static_cast<lua_Integer>(result.index) + 1);
      });
  lua_settop(L, list);
  return {1};
}

using Interval = std::tuple<double, double, double>;
Interval interval(const Estimate& estimate) { return {estimate.value, estimate.low, estimate.high}; }

double mean_of(const Values& values) { return mean(values.list); }
double median_of(const Values& values) { return median(values.list); }
Interval wilson_of(int successes, int count, const std::optional<double>& confidence) {
  return interval(wilson(successes, count, confidence.value_or(0.95)));
}
Interval mean_interval(const Values& values, const IntervalOptions& o, const Call& call) {
  Stream stream(o.seed, "bootstrap");
  return interval(bootstrap_mean(values.list, stream, o.resamples, o.confidence, call.work()));
}
Interval median_interval(const Values& values, const IntervalOptions& o, const Call& call) {
  Stream stream(o.seed, "bootstrap");
  return interval(bootstrap_median(values.list, stream, o.resamples, o.confidence, call.work()));
}
std::tuple<double, double, double, int, int, int> compare(const Values& a, const Values& b, const IntervalOptions& o,
                                                          const Call& call) {
  Stream stream(o.seed, "bootstrap");
  const PairedComparison c = compare_paired(a.list, b.list, stream, o.resamples, o.confidence, call.work());
  return {c.difference.value, c.difference.low, c.difference.high, c.a_larger, c.b_larger, c.equal};
}

constexpr Arg kValues{"values", "a sample: list of numbers or a view"};
constexpr Arg kInterval{"options", "confidence and resampling"};

void bind_statistics(Module module) {
  module
      .function<&mean_of>(Doc{.name = "mean",
                              .text = "The mean.",
                              .args = {kValues},
                              .returns = "number",
                              .errors = "an empty sample",
                              .example = "print(meander.study.mean {1, 2, 6})"})
      .function<&median_of>(Doc{.name = "median",
                                .text = "The median.",
                                .args = {kValues},
                                .returns = "number",
                                .errors = "an empty sample",
                                .example = "print(meander.study.median {1, 2, 6})"})
      .function<&wilson_of>(
          Doc{.name = "wilson",
              .text = "Share of successes with Wilson's score interval.",
              .args = {{"successes", "how many"}, {"trials", "of how many"}, {"confidence", "0.95 when left out"}},
              .returns = "share, lower and upper end",
              .errors = "more successes than trials; no trials",
              .example = "print(meander.study.wilson(18, 20))"})
      .function<&mean_interval>(Doc{.name = "bootstrap_mean",
                                    .text = "Mean with its bootstrap interval; the same seed gives the same.",
                                    .args = {kValues, kInterval},
                                    .returns = "mean, lower and upper end",
                                    .errors = "an empty sample",
                                    .example = "print(meander.study.bootstrap_mean({1, 2, 6}, { seed = 3 }))"})
      .function<&median_interval>(Doc{.name = "bootstrap_median",
                                      .text = "Median with its bootstrap interval; the same seed gives the same.",
                                      .args = {kValues, kInterval},
                                      .returns = "median, lower and upper end",
                                      .errors = "an empty sample",
                                      .example = "print(meander.study.bootstrap_median {1, 2, 6})"})
      .function<&compare>(
          Doc{.name = "compare",
              .text = "Two ways tried on the same seeds: mean difference with its bootstrap interval.",
              .args = {{"a", "results of one way"}, {"b", "of the other, in the same order"}, kInterval},
              .returns = "mean of a - b, lower and upper end, and how often a was larger, b was, neither",
              .errors = "samples of different size",
              .example = "print(meander.study.compare({1, 2, 6}, {2, 2, 3}))"});
}

}  // namespace

void bind_study(lua_State* L) {
  Module module(L, "meander.study", "Trials over seeds, and their statistics.");
  module.function<&trials>(Doc{
      .name = "trials",
      .text =
          "Runs a function over seeds. Each trial has its own process, forked when its turn comes, and math.random is "
          "seeded with its seed: nothing carries over from trial to trial or back to the caller, and the number "
          "of jobs changes no result. Results come in the order of the seeds.",
      .args = {{"options", "the function and the seeds"}},
      .returns = "list of tables: seed, ok, and value (of a run: its figures) or error",
      .returns_type = "list of table",
      .errors = "neither seeds nor count; no process to be had",
      .example =
          "r = meander.study.trials { seeds = {1, 2}, jobs = 1, trial = function(seed) return { twice = 2 * seed } "
          "end } print(r[2].value.twice)"});
  bind_statistics(module);
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_options.hpp"
#include "script/pack.hpp"
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
  visit(Field{"count", "", "so many trials, with seeds that follow from `seed`", 0, 1e9}, o.count);
  visit(Field{"seed", "", "from which the seeds of the trials follow"}, o.seed);
  visit(Field{"jobs", "", "worker processes; 0: one per core, 1: none, in this process", 0, 1024}, o.jobs);
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

/// One trial in a worker: the result as bytes. Lua's error becomes an exception, which a worker can report.
std::string run_trial(const Function& trial, std::uint64_t seed, std::size_t index) {
  lua_State* L = trial.push();
  luaL_checkstack(L, 4, nullptr);
  push(L, seed);
  push(L, static_cast<int>(index) + 1);
  if (lua_pcall(L, 2, 1, 0) != LUA_OK) {
    if (session(L).stop.requested()) throw Cancelled{};
    const std::string problem = luaL_tolstring(L, -1, nullptr);
    lua_pop(L, 2);
    throw Error(problem);
  }
  std::string bytes = pack(L, -1);
  lua_pop(L, 1);
  return bytes;
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

Pushed trials(const TrialsTable& table, const Call& call) {
  const std::vector<std::uint64_t> seeds = seeds_of(table);
  lua_State* L = call.L;
  lua_createtable(L, static_cast<int>(seeds.size()), 0);
  const int list = lua_gettop(L);
  run_trials(
      seeds.size(), table.jobs, call.work(), [&](std::size_t i) { return run_trial(table.trial.value, seeds[i], i); },
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
Interval mean_interval(const Values& values, const IntervalOptions& o) {
  Stream stream(o.seed, "bootstrap");
  return interval(bootstrap_mean(values.list, stream, o.resamples, o.confidence));
}
Interval median_interval(const Values& values, const IntervalOptions& o) {
  Stream stream(o.seed, "bootstrap");
  return interval(bootstrap_median(values.list, stream, o.resamples, o.confidence));
}
std::tuple<double, double, double, int, int, int> compare(const Values& a, const Values& b, const IntervalOptions& o) {
  Stream stream(o.seed, "bootstrap");
  const PairedComparison c = compare_paired(a.list, b.list, stream, o.resamples, o.confidence);
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
  module.function<&trials>(
      Doc{.name = "trials",
          .text = "Runs a function over seeds in worker processes; results come in seed order whatever finishes first.",
          .args = {{"options", "the function and the seeds"}},
          .returns = "list of tables: seed, ok, and value (of a run: its figures) or error",
          .errors = "neither seeds nor count",
          .example =
              "r = meander.study.trials { seeds = {1, 2}, jobs = 1, trial = function(seed) return { twice = 2 * seed } "
              "end } print(r[2].value.twice)"});
  bind_statistics(module);
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Arguments that make no sense, for every bound function: an error or a result, never a crash, a hang or a broken
// state. MEANDER_HOSTILE_CALLS sets the number of calls (40000 when it is not set).
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "base/random.hpp"
#include "script/bindings.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

namespace fs = std::filesystem;

/// Stops calls that take long, as Ctrl-C would.
class Watchdog {
 public:
  explicit Watchdog(StopToken& stop) : stop_(stop), thread_([this] { watch(); }) {}
  ~Watchdog() {
    done_ = true;
    thread_.join();
  }
  void begin() {
    stop_.clear();
    ++calls_;
  }

 private:
  void watch() {
    std::uint64_t seen = 0;
    while (!done_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if (seen == calls_.load()) stop_.request();
      seen = calls_.load();
    }
  }
  StopToken& stop_;
  std::atomic<std::uint64_t> calls_{0};
  std::atomic<bool> done_{false};
  std::thread thread_;
};

/// Lua expressions. `o` is a table of good objects, `closed` of closed ones.
const char* const kValues[] = {"nil",
                               "true",
                               "false",
                               "0",
                               "1",
                               "-1",
                               "2",
                               "0.5",
                               "7.3",
                               "1e9",
                               "-1e18",
                               "1e308",
                               "5e-324",
                               "0/0",
                               "1/0",
                               "-1/0",
                               "math.maxinteger",
                               "math.mininteger",
                               "''",
                               "'crate'",
                               "'hall'",
                               "'gate'",
                               "'*'",
                               "'c*'",
                               "'nomad200'",
                               "'ideal'",
                               "'potential_field'",
                               "'time'",
                               "'a.toml'",
                               "'a.svg'",
                               "'a.csv'",
                               "'a.jsonl'",
                               "'a.yaml'",
                               "'worlds/office.toml'",
                               "('x'):rep(5000)",
                               "'\\0\\255\\27[31m'",
                               "'{'",
                               "{}",
                               "{1}",
                               "{2, 2}",
                               "{4, 1, 0.3}",
                               "{1e300, -1e300}",
                               "{0/0, 0}",
                               "{1, 'x'}",
                               "{x = 3, y = 2}",
                               "{{1, 1}, {3, 1}, {3, 3}}",
                               "{{1, 1}, {3, 3}, {3, 1}, {1, 3}}",
                               "{{0, 0}, {20, 20}}",
                               "{{{1, 1}, {2, 2}, {1, 2}}}",
                               "{1, 2, 3, 4, 5}",
                               "cycle",
                               "long",
                               "trap",
                               "print",
                               "function() error('x') end",
                               "function() return 0.3, 0.1 end",
                               "function() return {2, 2} end",
                               "function(...) return ... end",
                               "function() closing() return 1 end",
                               "function() collectgarbage() return 0, 0 end",
                               "coroutine.create(print)",
                               "io.stdout",
                               "o.world",
                               "o.thing",
                               "o.sim",
                               "o.run",
                               "o.observation",
                               "o.reading",
                               "o.numbers",
                               "o.matrix",
                               "o.navigator",
                               "o.guide",
                               "o.robot",
                               "{o.thing, 'crate'}",
                               "{o.sim, o.run}",
                               "closed.world",
                               "closed.sim",
                               "closed.run",
                               "closed.numbers"};

const char* const kSetUp = R"(
  cycle = {} cycle[1] = cycle cycle.x = cycle
  long = {} for i = 1, 2000 do long[i] = {i / 100, (i * 7 % 13) / 5} end
  trap = setmetatable({}, {__index = function() error('index') end, __len = function() error('len') end,
    __pairs = function() error('pairs') end, __tostring = function() error('text') end, __name = 'trap'})
  closed = {}
  function fresh()
    local w = meander.world.new { title = 'yard', start = {1, 1, 0} }
    w:add_box { center = {4, 4}, size = {1, 1}, name = 'crate' }
    w:add_place { position = {6, 2}, name = 'hall' }
    w:add_door { from = {7, 7}, to = {8, 7}, name = 'gate' }
    w:add_mover { center = {8, 2}, radius = 0.2, waypoints = {{8, 4}}, name = 'anna' }
    local s = meander.sim.new { world = w }
    o = { world = w, thing = w:thing 'crate', sim = s, observation = s.observation, numbers = s.observation.sonar,
      run = s:drive { navigator = function() return 0.3, 0 end, subgoals = { {2, 1} } }, robot = s.state,
      reading = meander.sensor.scan { world = w }, matrix = meander.matrix { {1, 2}, {3, 4} },
      navigator = meander.polar.potential_field {}, guide = meander.autonomy.subgoal_list { subgoals = { {2, 2} } } }
  end
  function closing() for name in pairs(closed) do local x <close> = o[name] end fresh() end
  fresh()
  for _, name in ipairs { 'world', 'sim', 'run', 'numbers' } do closed[name] = o[name] local x <close> = o[name] end
  fresh()
)";

class Hostile : public ScriptState {
 protected:
  Hostile() : stream_(7, "hostile") {
    bind_all(L);
    session_.write = [](std::string_view) {};
    folder_ = fs::temp_directory_path() / ("meander_hostile_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    fs::copy(fs::path(MEANDER_SOURCE_DIR) / "worlds", folder_ / "worlds");  // a copy: calls may write
    before_ = fs::current_path();
    fs::current_path(folder_);
    EXPECT_EQ(run(std::string("print = function() end") + kSetUp), "");
  }
  ~Hostile() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }

  std::string any() { return kValues[stream_.below(static_cast<int>(std::size(kValues)))]; }

  /// A table with some of the known keys, most of them with nonsense.
  std::string options(const std::vector<OptionDoc>& known) {
    std::string text = "{";
    for (const OptionDoc& option : known)
      if (option.required ? stream_.chance(0.9) : stream_.chance(2.0 / static_cast<double>(known.size())))
        text += option.name + " = " + argument(option.values, option.options, option.type) + ", ";
    return text + "}";
  }

  std::string argument(const std::vector<std::string>& values, const std::vector<OptionDoc>& known,
                       const std::string& type) {
    if (!known.empty() && stream_.chance(0.6)) return options(known);
    if (!values.empty() && stream_.chance(0.5))
      return "'" + values[static_cast<std::size_t>(stream_.below(static_cast<int>(values.size())))] + "'";
    if (stream_.chance(0.4)) {
      if (type == "number") return stream_.chance(0.5) ? "1.5" : "0.1";
      if (type == "integer") return "2";
      if (type == "{x, y}") return "{5, 5}";
      if (type == "world" || type == "observation") return "o." + type;
    }
    return any();
  }

  std::string call(const Record& record) {
    if (record.kind == DocKind::property)
      return stream_.chance(0.7) ? "return o." + record.owner + "." + record.member
                                 : "o." + record.owner + "." + record.member + " = " + any();
    std::string text = record.name() + "(";
    if (record.kind == DocKind::method) {
      const std::string self = stream_.chance(0.9) ? "o." + record.owner : any();
      text = "local f = o." + record.owner + "." + record.member + " return f(" + self;
      if (!record.arguments.empty()) text += ", ";
    }
    for (std::size_t i = 0; i < record.arguments.size(); ++i) {
      const ArgumentDoc& arg = record.arguments[i];
      text += (i ? ", " : "") + argument(arg.values, arg.options, arg.type);
    }
    if (stream_.chance(0.03)) text += (text.back() == '(' ? "" : ", ") + any();
    return text + ")";
  }

  Stream stream_;
  fs::path folder_, before_;
};

TEST_F(Hostile, NoArgumentBreaksAnything) {
  const char* wanted = std::getenv("MEANDER_HOSTILE_CALLS");
  const int count = wanted ? std::atoi(wanted) : 40000;
  std::vector<const Record*> targets;
  for (const Record& record : session_.docs.all())
    // Trials fork as many processes as they are told: tested by themselves.
    if (record.kind != DocKind::module && record.kind != DocKind::type && record.name() != "meander.study.trials")
      targets.push_back(&record);
  Watchdog watchdog(session_.stop);
  int fine = 0;
  for (int i = 0; i < count; ++i) {
    const Record& record = *targets[static_cast<std::size_t>(stream_.below(static_cast<int>(targets.size())))];
    const std::string code = call(record);
    SCOPED_TRACE(code);
    watchdog.begin();
    const std::string result = run(code);
    fine += !result.starts_with("error");
    EXPECT_EQ(result.find('\n') == std::string::npos || !result.starts_with("error"), true) << result;
    if (i % 50 == 0) {
      std::string made;
      do {  // a busy machine may take longer than the watchdog's patience
        watchdog.begin();
        made = run("fresh()");
      } while (made == "error: interrupted");
      ASSERT_EQ(made, "");
    }
  }
  EXPECT_GT(fine, count / 10) << "too few calls that mean something";
}

}  // namespace
}  // namespace meander::script

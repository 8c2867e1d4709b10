// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Walks the whole live API: every name has a record, every record a live name, every example runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "script/bindings.hpp"
#include "script/help_text.hpp"
#include "script/kit_module.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

namespace fs = std::filesystem;

class Api : public ScriptState {
 protected:
  Api() {
    bind_all(L);
    session_.write = [this](std::string_view text) { written_ += text; };
  }

  /// Names of functions and modules below the module table on top of the stack.
  void walk(const std::string& path, std::set<std::string>& names) {
    lua_pushnil(L);
    for (; lua_next(L, -2); lua_pop(L, 1)) {
      ASSERT_EQ(lua_type(L, -2), LUA_TSTRING);
      const std::string name = path + "." + lua_tostring(L, -2);
      names.insert(name);
      const Record* record = record_of(L, -1);
      ASSERT_TRUE(record) << name;
      EXPECT_EQ(record->name(), name);
      if (lua_istable(L, -1)) walk(name, names);
    }
  }

  std::string written_;
};

TEST_F(Api, EveryLiveNameHasARecordAndTheReverse) {
  std::set<std::string> live;
  lua_getglobal(L, "meander");
  walk("meander", live);
  EXPECT_GT(live.size(), 25u);
  for (const Record& record : session_.docs.all()) {
    if (record.kind == DocKind::module && record.name() != "meander") {
      EXPECT_TRUE(live.contains(record.name())) << record.name();
    }
    if (record.kind != DocKind::function) continue;
    if (record.owner.empty()) {
      EXPECT_EQ(lua_getglobal(L, record.member.c_str()), LUA_TFUNCTION) << record.name();
      EXPECT_EQ(record_of(L, -1), &record);
      lua_pop(L, 1);
    } else {
      EXPECT_TRUE(live.contains(record.name())) << record.name();
    }
  }
}

TEST_F(Api, RecordsReadWell) {
  for (const Record& record : session_.docs.all()) {
    SCOPED_TRACE(record.name());
    EXPECT_FALSE(record.text.empty());
    if (record.kind == DocKind::module || record.kind == DocKind::type) continue;
    EXPECT_TRUE(record.text.ends_with('.') || record.text.ends_with('?')) << record.text;
    EXPECT_FALSE(record.example.empty());
    for (const ArgumentDoc& argument : record.arguments) {
      EXPECT_FALSE(argument.type.empty()) << argument.name;
      for (const OptionDoc& option : argument.options) EXPECT_FALSE(option.text.empty()) << option.name;
    }
    EXPECT_EQ(session_.docs.find(record.name()), &record) << "two things of one name";
    EXPECT_NE(help_text(session_.docs, record).find(record.member), std::string::npos);
  }
}

TEST_F(Api, EveryExampleRuns) {
  const fs::path folder = fs::temp_directory_path() / ("meander_api_" + std::to_string(getpid()));
  fs::create_directories(folder);
  fs::copy(fs::path(MEANDER_SOURCE_DIR) / "worlds", folder / "worlds");  // a copy: examples may write
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  run("print = function(...) for i = 1, select('#', ...) do tostring((select(i, ...))) end end\n"
      "os.tmpname = function() count = (count or 0) + 1 return './' .. count end");
  for (const Record& record : session_.docs.all()) {
    if (record.example.empty()) continue;
    const std::string result = run(record.example);
    EXPECT_FALSE(result.starts_with("error")) << record.name() << ": " << record.example << "\n" << result;
  }
  fs::current_path(before);
  fs::remove_all(folder);
}

TEST_F(Api, HelpFindsEverythingByNameAndByValue) {
  for (const Record& record : session_.docs.all()) {
    written_.clear();
    EXPECT_EQ(run("help '" + record.name() + "'"), "") << record.name();
    EXPECT_TRUE(written_.starts_with(record.name())) << written_;
  }
  written_.clear();
  EXPECT_EQ(run("help(meander.sim.new) help(meander.world) help(meander.world.new {}) help(deg)"), "");
  for (const char* start : {"meander.sim.new { options }\n", "meander.world\n", "\nworld\n", "\ndeg(angle)\n"})
    EXPECT_NE(written_.find(start), std::string::npos) << start << written_;
  written_.clear();
  EXPECT_EQ(run("help()"), "");
  for (const char* part : {"functions\n", "  meander.matrix(rows)", "modules\n", "objects\n", "meander.sim", "  sim "})
    EXPECT_NE(written_.find(part), std::string::npos) << part << written_;
  EXPECT_EQ(run("help 'sim:drvie'"),
            "error: test:1: help: nothing is known about 'sim:drvie'; did you mean 'sim:drive'?");
  EXPECT_EQ(run("help(print)").substr(0, 24), "error: test:1: help: a n");
  written_.clear();
  EXPECT_EQ(run("apropos 'sonar' apropos 'xyzzy'"), "");
  EXPECT_NE(written_.find("meander.sensor.scan { options }"), std::string::npos) << written_;
  EXPECT_NE(written_.find("nothing is known about 'xyzzy'"), std::string::npos);
}

TEST_F(Api, HelpOfAFunctionTellsOptionsUnitsAndValues) {
  run("help 'meander.sim.new'");
  for (const char* part :
       {"world", "must be given", "'nomad200'", "seed of all random streams", "[m, rad]", "fails on", "example"})
    EXPECT_NE(written_.find(part), std::string::npos) << part << "\n" << written_;
  // The bumper's defaults are those of the platform; tables under `robots` are not told again.
  for (const char* part :
       {"20 when left out", "0.2667 when left out", "; robot, sonar, drift, whisker, light, start as above"})
    EXPECT_NE(written_.find(part), std::string::npos) << part << "\n" << written_;
  EXPECT_LT(std::count(written_.begin(), written_.end(), '\n'), 90);
  written_.clear();
  run("apropos 'noise'");
  for (const char* part : {"meander.sim.new { options }", "\n      drift.distance_noise  ", "\n      sonar.noise  "})
    EXPECT_NE(written_.find(part), std::string::npos) << part << "\n" << written_;
  written_.clear();
  run("help 'sim:drive'");
  EXPECT_NE(written_.find("'potential_field'"), std::string::npos) << written_;
}

}  // namespace
}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What is generated from the records: every name has an entry, an annotation that Lua can read, and a test.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "script/bindings.hpp"
#include "script/example_lines.hpp"
#include "script/help_text.hpp"
#include "script/luals_stubs.hpp"
#include "script/reference_text.hpp"
#include "script/type_annotation.hpp"
#include "script_state.hpp"

namespace meander::script {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

bool is_call(const Record& record) { return record.kind == DocKind::function || record.kind == DocKind::method; }

class Reference : public ScriptState {
 protected:
  Reference() { bind_all(L); }

  const Docs& docs() { return session_.docs; }
  bool compiles(const std::string& lua) { return luaL_loadbuffer(L, lua.data(), lua.size(), "=lua") == LUA_OK; }

  void expect_known_types(const std::vector<OptionDoc>& options, const std::string& owner) {
    for (const OptionDoc& option : options) {
      expect_known_type(option.type, owner + ", option " + option.name);
      expect_known_types(option.options, owner);
    }
  }
  void expect_known_type(const std::string& type, const std::string& where) {
    if (type.empty()) return;  // nothing is returned
    EXPECT_EQ(type_annotation(type, {docs()}).find("unknown"), std::string::npos)
        << where << ": " << type << ": src/script/type_annotation.cpp does not know what that is";
  }
};

TEST_F(Reference, EveryNameHasOneEntryThatLinksFind) {
  const std::string page = reference_text(docs());
  for (const Record& record : docs().all()) {
    const bool chapter = record.kind == DocKind::module || record.kind == DocKind::type;
    const std::string heading = (chapter ? "\n## " : "\n### ") + record.name() + "\n";
    const std::size_t at = page.find(heading);
    EXPECT_NE(at, std::string::npos) << record.name();
    EXPECT_EQ(page.find(heading, at + 1), std::string::npos) << record.name();
  }
  // GitHub numbers headings that would have the same link: then some link would lead to the wrong one.
  std::map<std::string, int> anchors;
  const std::regex heading("\n##+ ([^\n]*)"), link("\\]\\(#([^)]*)\\)"), punctuation("[^a-z0-9_-]");
  for (std::sregex_iterator it(page.begin(), page.end(), heading), end; it != end; ++it) {
    std::string name = it->str(1);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    EXPECT_EQ(++anchors[std::regex_replace(name, punctuation, "")], 1) << name;
  }
  for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it)
    EXPECT_TRUE(anchors.contains(it->str(1))) << it->str();
}

TEST_F(Reference, TablesOfThePageHaveTheirColumns) {
  std::istringstream page(reference_text(docs()));
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with('|')) continue;
    std::string plain = std::regex_replace(line, std::regex("\\\\\\|"), "");
    EXPECT_EQ(std::count(plain.begin(), plain.end(), '|'), 6) << line;
  }
}

TEST_F(Reference, AnnotationsAreLuaAndNameEveryArgument) {
  const std::string stubs = luals_stubs(docs());
  ASSERT_TRUE(compiles(stubs)) << lua_tostring(L, -1);
  ASSERT_EQ(lua_pcall(L, 0, 0, 0), LUA_OK) << lua_tostring(L, -1);
  std::set<std::string> parameters, functions;
  std::istringstream lines(stubs);
  const std::regex parameter("---@param (\\w+)\\??  ?.*"), function("function ([\\w.:]+)\\((.*)\\) end");
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, parameter)) parameters.insert(match[1]);
    if (!std::regex_match(line, match, function)) continue;
    const Record* record = docs().find(match.str(1));
    ASSERT_TRUE(record) << line;
    EXPECT_EQ(parameters.size(), record->arguments.size()) << line;
    for (const std::string& name : parameters) EXPECT_NE(match.str(2).find(name), std::string::npos) << line;
    functions.insert(match[1]);
    parameters.clear();
  }
  for (const Record& record : docs().all()) {
    const bool type = record.kind == DocKind::type, property = record.kind == DocKind::property;
    EXPECT_TRUE(!is_call(record) || functions.contains(record.name())) << record.name();
    EXPECT_TRUE(!property || stubs.find("---@field " + record.member + " ") != std::string::npos) << record.name();
    EXPECT_TRUE(!type || stubs.find("---@class " + record.name() + "\n") != std::string::npos) << record.name();
  }
}

TEST_F(Reference, EveryTypeHasAnAnnotation) {
  for (const Record& record : docs().all()) {
    expect_known_type(record.returns_type, record.name());
    for (const ArgumentDoc& argument : record.arguments) {
      expect_known_type(argument.type, record.name() + ", argument " + argument.name);
      expect_known_types(argument.options, record.name());
    }
  }
}

TEST_F(Reference, TypesInWordsBecomeAnnotations) {
  const TypeWords words{docs(), "sim.options", "meander.sonar_name"};
  const std::pair<const char*, const char*> cases[] = {
      {"number", "number"},
      {"list of thing", "thing[]"},
      {"list of list of number", "number[][]"},
      {"list of place, {x, y} or {x =, y =}", "(string|thing|meander.point|{ x?: any, y?: any })[]"},
      {"number, {v =, w =} or list of {v =, w =}", "number|{ v?: any, w?: any }|({ v?: any, w?: any })[]"},
      {"thing, name, pattern or list of these", "thing|meander.sonar_name|string|(thing|meander.sonar_name|string)[]"},
      {"{x, y, heading} or false", "meander.pose|false"},
      {"'stop' | 'skip'", "'stop'|'skip'"},
      {"name or table of options", "meander.sonar_name|sim.options"},
      {"list of table", "sim.options[]"},
      {"navigator, function(observation, subgoal) or table of functions",
       "navigator|fun(observation: observation, subgoal: any): ...any|table<string, function>"},
      {"whatnot", "unknown"},
  };
  for (const auto& [type, annotation] : cases) EXPECT_EQ(type_annotation(type, words), annotation);
  using Texts = std::vector<std::string>;
  EXPECT_EQ(result_annotations("world, list of string", words), (Texts{"world", "string[]"}));
  EXPECT_EQ(result_annotations("number or nil, thing or nil", words), (Texts{"number|nil", "thing|nil"}));
  EXPECT_EQ(result_annotations("thing, name or list of thing", words), Texts{"thing|meander.sonar_name|thing[]"});
}

TEST_F(Reference, ExamplesAreSplitBetweenStatementsOnly) {
  EXPECT_EQ(example_lines("a = f {1, 2} b = a :c(3) print(a, b)"), "a = f {1, 2}\nb = a :c(3)\nprint(a, b)");
  EXPECT_EQ(example_lines("x = f (g)(1) y = 2"), "x = f (g)(1)\ny = 2");
  EXPECT_EQ(example_lines("for i = 1, 2 do print(i) end help 'a b'"), "for i = 1, 2 do print(i) end\nhelp 'a b'");
  EXPECT_EQ(example_lines("no lua, this"), "no lua, this");
  for (const Record& record : docs().all()) EXPECT_TRUE(compiles(example_lines(record.example))) << record.example;
}

/// Lua in the tests: transcripts, scripts, and the texts inside C++.
std::string lua_of_tests() {
  const std::regex quoted("\"((?:[^\"\\\\\n]|\\\\.)*)\"");
  std::string all;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(MEANDER_SOURCE_DIR) / "tests")) {
    const std::string suffix = entry.path().extension().string();
    const std::string name = entry.path().filename().string();
    if (suffix == ".txt" || suffix == ".lua") all += text_of(entry.path());
    if (suffix != ".cpp" || !(name.starts_with("script_") || name.starts_with("repl_"))) continue;
    const std::string source = text_of(entry.path());
    for (std::sregex_iterator it(source.begin(), source.end(), quoted), end; it != end; ++it) all += it->str(1) + "\n";
  }
  return all;
}

TEST_F(Reference, EveryNameIsMentionedByATest) {
  const std::string lua = lua_of_tests();
  const std::regex word("([.:]|\\b)(\\w+)");
  std::set<std::string> members, plain;
  for (std::sregex_iterator it(lua.begin(), lua.end(), word), end; it != end; ++it)
    (it->str(1).empty() ? plain : members).insert(it->str(2));
  for (const Record& record : docs().all()) {
    const bool global = record.owner.empty();
    if (record.kind == DocKind::type || record.kind == DocKind::module) continue;
    EXPECT_TRUE((global ? plain : members).contains(record.member)) << record.name() << ": write a test that uses it";
  }
}

TEST_F(Reference, TheManualPageNamesEveryVariableThatIsRead) {
  const std::string page = text_of(fs::path(MEANDER_SOURCE_DIR) / "docs" / "meander.1");
  const std::regex read("(?:getenv|environment|variable)\\(\"([A-Z_]+)\"");
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(MEANDER_SOURCE_DIR) / "src")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string source = text_of(entry.path());
    for (std::sregex_iterator it(source.begin(), source.end(), read), end; it != end; ++it)
      EXPECT_NE(page.find(".B " + it->str(1) + "\n"), std::string::npos)
          << entry.path() << " reads " << it->str(1) << ": add it to src/app/man_page.cpp";
  }
}

}  // namespace
}  // namespace meander::script

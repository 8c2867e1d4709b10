// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/control_options.hpp"

#include "autonomy/navigators.hpp"
#include "world/placement.hpp"

namespace meander::script {
namespace {

/// table[name] as a function, if it is there.
std::optional<Function> member_function(lua_State* L, int table, const Path& path, const char* name) {
  push_option(L, table, name);
  const auto function =
      Lua<std::optional<Function>>::read(L, -1, Path{.kind = Path::Kind::option, .name = name, .parent = &path});
  lua_pop(L, 1);
  return function;
}

std::string member_name(lua_State* L, int table, const Path& path) {
  push_option(L, table, "name");
  const auto name =
      Lua<std::optional<std::string>>::read(L, -1, Path{.kind = Path::Kind::option, .name = "name", .parent = &path});
  lua_pop(L, 1);
  return name.value_or("lua");
}

/// The results of a navigator in Lua: v, w, status, reason.
NavigatorStep step_in_lua(const Function& function, const Observation& observation, const Subgoal& subgoal) {
  lua_State* L = function.invoke(4, observation, subgoal);
  const Path path = function.result_path();
  if (lua_type(L, -4) != LUA_TNUMBER || lua_type(L, -3) != LUA_TNUMBER)
    fail("{}: two numbers v, w expected, got {}, {}", path.text(), describe(L, -4), describe(L, -3));
  NavigatorStep step;
  step.command = {read_number(L, -4, path), read_number(L, -3, path), 0};
  step.status = Lua<std::optional<NavigatorStatus>>::read(L, -2, path).value_or(NavigatorStatus::driving);
  step.reason = Lua<std::optional<std::string>>::read(L, -1, path).value_or("");
  lua_pop(L, 4);
  return step;
}

/// The results of a guide in Lua: subgoal, or nil / true when finished; a reason; how many were reached.
GuideStep next_in_lua(const Function& function, const Observation& observation, const NavigatorStep& last) {
  lua_State* L = function.invoke(3, observation, last);
  const Path path = function.result_path();
  GuideStep step;
  if (lua_isnoneornil(L, -3) || lua_isboolean(L, -3))
    step.success = lua_toboolean(L, -3);
  else
    step.subgoal = Lua<SubgoalOption>::read(L, -3, path).in(nullptr);
  step.reason = Lua<std::optional<std::string>>::read(L, -2, path).value_or("");
  if (!step.subgoal && step.reason.empty()) step.reason = "the guide finished without a reason";
  step.reached = Lua<std::optional<int>>::read(L, -1, path).value_or(0);
  lua_pop(L, 3);
  return step;
}

/// A goal outside the bounds or inside something can only be a mistake. (An edit may still cover it later.)
void check_goal(const World& world, const Spot& spot) {
  check_within(spot, world.header().bounds);
  for (const Id id : world.ids()) check_apart(world.item(id), spot);
}

std::function<void()> reset_of(const std::optional<Function>& reset) {
  if (!reset) return [] {};
  return [reset] { reset->call(); };
}

Navigator lua_navigator(const Function& step, const std::optional<Function>& reset, const std::string& name) {
  return {name, [step](const Observation& o, const Subgoal& s) { return step_in_lua(step, o, s); }, reset_of(reset)};
}

/// The same object, not a copy: what it has learnt stays in it.
Navigator shared(const std::shared_ptr<Navigator>& navigator) {
  return {navigator->name, [navigator](const Observation& o, const Subgoal& s) { return navigator->step(o, s); },
          [navigator] { navigator->reset(); }, navigator->body_radius};
}
Guide shared(const std::shared_ptr<Guide>& guide) {
  return {guide->name, [guide](const Observation& o, const NavigatorStep& s) { return guide->next(o, s); },
          [guide] { guide->reset(); }, guide->subgoals};
}

}  // namespace

NavigatorOption Lua<NavigatorOption>::read(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) == LUA_TSTRING) {
    const std::string name(read_text(L, index, path));
    const std::vector<std::string> known = navigator_names();
    if (std::find(known.begin(), known.end(), name) == known.end()) unknown_value(path, name, known);
    return {[name](const Platform& platform) { return navigator_by_name(name, platform); }};
  }
  if (test_box(L, index, tag_of<Navigator>)) {
    const auto object = read_object<Navigator>(L, index, path);
    return {[navigator = shared(object)](const Platform&) { return navigator; }, object.get()};
  }
  Navigator navigator;
  if (lua_isfunction(L, index)) {
    navigator = lua_navigator(Function(L, index, path), {}, "lua");
  } else if (lua_istable(L, index)) {
    const int table = lua_absindex(L, index);
    check_keys(L, table, path, {"step", "reset", "name"});
    const auto step = member_function(L, table, path, "step");
    if (!step) fail("{}: missing, function(observation, subgoal) expected", option_prefix(path) + "step");
    navigator = lua_navigator(*step, member_function(L, table, path, "reset"), member_name(L, table, path));
  } else {
    expected(L, index, path, type());
  }
  return {[navigator](const Platform&) { return navigator; }};
}

void Describe<NavigatorOption>::into(OptionDoc& doc) { doc.values = navigator_names(); }

GuideOption Lua<GuideOption>::read(lua_State* L, int index, const Path& path) {
  Guide guide;
  std::optional<Function> next, reset;
  if (test_box(L, index, tag_of<Guide>)) {
    const auto object = read_object<Guide>(L, index, path);
    return {[guide = shared(object)](const World&) { return guide; }, object.get()};
  }
  if (lua_isfunction(L, index)) {
    next = Function(L, index, path);
    guide.name = "lua";
  } else if (lua_istable(L, index)) {
    const int table = lua_absindex(L, index);
    check_keys(L, table, path, {"next", "reset", "name", "subgoals"});
    next = member_function(L, table, path, "next");
    if (!next) fail("{}: missing, function(observation, status) expected", option_prefix(path) + "next");
    reset = member_function(L, table, path, "reset");
    guide.name = member_name(L, table, path);
    push_option(L, table, "subgoals");
    guide.subgoals = Lua<std::optional<int>>::read(L, -1, path).value_or(0);
    lua_pop(L, 1);
  } else {
    expected(L, index, path, type());
  }
  guide.next = [f = *next](const Observation& o, const NavigatorStep& s) { return next_in_lua(f, o, s); };
  guide.reset = reset_of(reset);
  return {[guide](const World&) { return guide; }};
}

Pilot pilot_of(const PilotTable& table, const World& world, const Platform& platform) {
  if (!table.navigator) fail("option 'navigator': missing, {} expected", Lua<NavigatorOption>::type());
  if (table.guide && !table.subgoals.empty()) fail("options 'guide' and 'subgoals': one of them expected, got both");
  if (!table.guide && table.subgoals.empty()) fail("option 'subgoals': missing, a list of places or points expected");
  if (table.guide) return {table.navigator->make(platform), table.guide->make(world)};
  std::vector<Subgoal> subgoals;
  for (const SubgoalOption& option : table.subgoals) {
    subgoals.push_back(option.in(&world));
    check_goal(world, {fmt::format("subgoal {}", subgoals.size()), subgoals.back().position});
  }
  return {table.navigator->make(platform), subgoal_list(std::move(subgoals), table.list)};
}

}  // namespace meander::script

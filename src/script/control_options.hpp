// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>

#include "autonomy/subgoal_list.hpp"
#include "script/item_options.hpp"
#include "script/kit_function.hpp"
#include "study/drive.hpp"

namespace meander::script {

/// Who drives: a name, a navigator, a Lua function, or a table of functions {step =, reset =, name =}.
struct NavigatorOption {
  std::function<Navigator(const Platform&)> make;
  const void* object = nullptr;  ///< the navigator object given, if it was one: it serves one run at a time
};
template <>
struct Lua<NavigatorOption> {
  static NavigatorOption read(lua_State* L, int index, const Path& path);
  static std::string type() { return "name, navigator, function(observation, subgoal) or table of functions"; }
};
template <>
struct Describe<NavigatorOption> {
  static void into(OptionDoc& doc);
};

/// Who says where to: a guide, a Lua function, or a table of functions {next =, reset =, name =, subgoals =}.
struct GuideOption {
  std::function<Guide(const World&)> make;
  const void* object = nullptr;  ///< the guide object given, if it was one: it serves one run at a time
};
template <>
struct Lua<GuideOption> {
  static GuideOption read(lua_State* L, int index, const Path& path);
  static std::string type() { return "guide, function(observation, status) or table of functions"; }
};

/// A place, a point, or {x =, y =, tolerance =, heading =, name =}.
struct SubgoalOption {
  Subgoal subgoal;
  std::optional<ThingRef> place;
  /// In the frame of the world, which is that of the odometry at the start.
  Subgoal in(const World* world) const;
};
template <>
struct Lua<SubgoalOption> {
  static SubgoalOption read(lua_State* L, int index, const Path& path);
  static std::string type() { return "place, {x, y} or {x =, y =, tolerance =, heading =, name =}"; }
};
template <>
struct Lua<Subgoal> {
  static void push(lua_State* L, const Subgoal& subgoal);
  static std::string type() { return "{x, y, tolerance =, heading =, name =}"; }
};
template <>
struct Lua<NavigatorStep> {
  static void push(lua_State* L, const NavigatorStep& step);
  static std::string type() { return "table"; }
};

/// One robot's part of a drive.
struct PilotTable {
  std::optional<NavigatorOption> navigator;
  std::optional<GuideOption> guide;
  std::vector<SubgoalOption> subgoals;
  SubgoalListOptions list;
};
template <class Options, class Visitor>
void pilot_fields(Options& o, Visitor&& visit) {
  visit(Field{"navigator", "", "who drives"}, o.navigator);
  visit(Field{"subgoals", "m", "where to: places or points, one after the other"}, o.subgoals);
  visit(Field{"guide", "", "who says where to, instead of a list of subgoals"}, o.guide);
  fields(o.list, visit);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PilotTable>
void fields(Options& o, Visitor&& visit) { pilot_fields(o, visit); }

Pilot pilot_of(const PilotTable& table, const World& world, const Platform& platform);

}  // namespace meander::script

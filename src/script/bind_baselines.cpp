// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/dynamic_window.hpp"
#include "polar/tangent_bug.hpp"
#include "polar/vfh_plus.hpp"
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/objects.hpp"
#include "script/robot_options.hpp"

namespace meander::script {

/// A navigator's options beside the robot that it drives.
template <class Options>
struct BaselineTable {
  Preset<Platform> robot;
  Options options;
};
template <class T>
inline constexpr bool kBaselineTable = false;
template <class Options>
inline constexpr bool kBaselineTable<BaselineTable<Options>> = true;
template <class Table, class Visitor>
requires kBaselineTable<std::remove_const_t<Table>>
void fields(Table& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot that it drives"}, o.robot);
  fields(o.options, visit);
}

namespace {

template <class Options, Navigator (*make)(const Platform&, const Options&)>
std::shared_ptr<Navigator> baseline(const BaselineTable<Options>& table) {
  return std::make_shared<Navigator>(make(table.robot.value, table.options));
}

constexpr Arg kOptions{"options", "the robot it drives, and the method"};

}  // namespace

void bind_baselines(lua_State* L) {
  Module(L, "meander.polar", "")
      .function<&baseline<VfhPlusOptions, &vfh_plus>>(
          Doc{.name = "vfh_plus",
              .text = "VFH+: a polar histogram of what was seen lately, from which free directions are picked by cost.",
              .args = {kOptions},
              .returns = "the navigator",
              .errors = "a number out of range",
              .example = "print(meander.polar.vfh_plus { window = 1.5 })"})
      .function<&baseline<DynamicWindowOptions, &dynamic_window>>(Doc{
          .name = "dynamic_window",
          .text = "The dynamic window approach: of the velocities in reach, the best sum of heading, free way, speed.",
          .args = {kOptions},
          .returns = "the navigator",
          .errors = "a number out of range",
          .example = "print(meander.polar.dynamic_window { heading_weight = 1 })"})
      .function<&baseline<TangentBugOptions, &tangent_bug>>(
          Doc{.name = "tangent_bug",
              .text = "TangentBug: to the subgoal past the ends of what is in the way, else along walls.",
              .args = {kOptions},
              .returns = "the navigator",
              .errors = "a number out of range",
              .example = "print(meander.polar.tangent_bug { reach = 2 })"});
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/navigators.hpp"

#include "polar/potential_field.hpp"
#include "script/bind.hpp"
#include "script/control_options.hpp"
#include "script/example_text.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/robot_options.hpp"

namespace meander::script {

struct PotentialFieldTable {
  Preset<Platform> robot;
  PotentialFieldOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PotentialFieldTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot that it drives"}, o.robot);
  fields(o.options, visit);
}

struct SubgoalListTable {
  Required<std::vector<SubgoalOption>> subgoals;
  SubgoalListOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SubgoalListTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"subgoals", "m", "where to: points, one after the other"}, o.subgoals);
  fields(o.options, visit);
}

namespace {

std::shared_ptr<Navigator> field(const PotentialFieldTable& table) {
  return std::make_shared<Navigator>(potential_field(table.robot.value, table.options));
}

std::shared_ptr<Navigator> by_name(const std::string& name, const std::optional<Preset<Platform>>& robot) {
  return std::make_shared<Navigator>(navigator_by_name(name, robot.value_or(Preset<Platform>{}).value));
}

std::shared_ptr<Guide> list(const SubgoalListTable& table) {
  std::vector<Subgoal> subgoals;
  for (const SubgoalOption& option : table.subgoals.value) subgoals.push_back(option.in(nullptr));
  return std::make_shared<Guide>(subgoal_list(std::move(subgoals), table.options));
}

std::tuple<double, double, NavigatorStatus, std::string> step(Navigator& navigator, const Observation& observation,
                                                              const SubgoalOption& subgoal, const Call& call) {
  const InUse in_use(call.L, &navigator, "navigator");
  const NavigatorStep step = navigator.step(observation, subgoal.in(nullptr));
  return {step.command.v, step.command.w, step.status, step.reason};
}
void reset_navigator(Navigator& navigator, const Call& call) {
  const InUse in_use(call.L, &navigator, "navigator");
  navigator.reset();
}
void reset_guide(Guide& guide, const Call& call) {
  const InUse in_use(call.L, &guide, "guide");
  guide.reset();
}
std::string navigator_text(const Navigator& navigator) { return "navigator \"" + navigator.name + "\""; }
std::string guide_text(const Guide& guide) { return "guide \"" + guide.name + "\""; }

void bind_modules(lua_State* L) {
  Module(L, "meander.polar", "Local navigation by sonar readings and odometry alone.")
      .function<&field>(
          Doc{.name = "potential_field",
              .text = "Artificial potential field on the readings of the present cycle: no memory, no map.",
              .args = {{"options", "the robot it drives, and the field"}},
              .returns = "the navigator",
              .errors = "a number out of range",
              .example = "print(meander.polar.potential_field { influence = 0.8 })"});
  Module(L, "meander.autonomy", "Navigators and guides by name.")
      .function<&navigator_names>(Doc{.name = "navigators",
                                      .text = "The names that sim:drive takes as navigator.",
                                      .returns = "list of names",
                                      .example = "print(meander.autonomy.navigators()[1])"})
      .function<&by_name>(Doc{.name = "navigator",
                              .text = "A navigator by name, with its usual options.",
                              .args = {{"name", "which"}, {"robot", "kind of robot; nomad200 when left out"}},
                              .returns = "the navigator",
                              .errors = "unknown name",
                              .example = "print(meander.autonomy.navigator 'potential_field')"})
      .function<&list>(Doc{.name = "subgoal_list",
                           .text = "A guide: one subgoal after the other.",
                           .args = {{"options", "the subgoals, and when the next one's turn is"}},
                           .returns = "the guide",
                           .errors = "no subgoal; names of places, because a guide knows no world",
                           .example = "print(meander.autonomy.subgoal_list { subgoals = { {4, 2}, {6, 2} } })"});
}

}  // namespace

void bind_navigators(lua_State* L) {
  bind_modules(L);
  Type<Navigator>(L, "Drives towards one subgoal by readings and odometry alone.")
      .method<&step>(
          Doc{.name = "step",
              .text = "What to do now.",
              .args = {{"observation", "what the robot sees"}, {"subgoal", "where to, in the odometry frame", "m"}},
              .returns = "v [m/s], w [rad/s], status ('driving', 'arrived', 'trapped') and the reason when trapped",
              .example = EXAMPLE_SIM "print(meander.polar.potential_field({}):step(s.observation, {4, 2}))"})
      .method<&reset_navigator>(Doc{.name = "reset",
                                    .text = "Forgets everything: a new run begins.",
                                    .example = "meander.polar.potential_field({}):reset()"})
      .property<&Navigator::name>(
          PropertyDoc{.name = "name", .text = "Its name.", .example = "print(meander.polar.potential_field({}).name)"})
      .text<&navigator_text>();
  Type<Guide>(L, "Says where to go next.")
      .method<&reset_guide>(Doc{.name = "reset",
                                .text = "Begins again.",
                                .example = "meander.autonomy.subgoal_list({ subgoals = { {4, 2} } }):reset()"})
      .property<&Guide::name>(
          PropertyDoc{.name = "name",
                      .text = "Its name.",
                      .example = "print(meander.autonomy.subgoal_list({ subgoals = { {4, 2} } }).name)"})
      .text<&guide_text>();
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/sonar_explorer_text.hpp"

#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/indicator_objects.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"
#include "script/picture.hpp"
#include "script/robot_options.hpp"

namespace meander {

std::size_t native_size(const SonarExplorer& explorer) {
  const ConfigurationSpace& space = explorer.map().space();
  return sizeof(SonarExplorer) + native_size(explorer.explorer()) +
         16 * static_cast<std::size_t>(space.width()) * static_cast<std::size_t>(space.height());
}

}  // namespace meander

namespace meander::script {

template <>
struct ObjectName<SonarExplorer> {
  static constexpr const char* value = "sonar_explorer";
};

struct SonarExplorerTable {
  Required<Vec2> goal;
  Preset<Platform> robot;
  SonarExplorerOptions options;
  ExplorerListeners listeners;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarExplorerTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"goal", "m", "where to, in the odometry frame"}, o.goal);
  visit(Field{"robot", "", "kind of robot"}, o.robot);
  fields(o.options, visit);
  fields(o.listeners, visit);
}

namespace {

std::shared_ptr<SonarExplorer> make(const SonarExplorerTable& table) {
  auto explorer = std::make_shared<SonarExplorer>(table.goal.value, table.robot.value, table.options);
  listen(explorer->explorer(), table.listeners);
  return explorer;
}
std::shared_ptr<SonarExplorer> open(const InputFile& file, const ExplorerListeners& functions) {
  auto explorer = read_sonar_explorer(file.path);
  listen(explorer->explorer(), functions);
  return explorer;
}
void save(const SonarExplorer& explorer, const OutputFile& file) { write_sonar_explorer(explorer, file.path); }
std::shared_ptr<Guide> guide(const std::shared_ptr<SonarExplorer>& explorer) {
  return std::make_shared<Guide>(exploring_guide(explorer));
}
std::shared_ptr<IndicatorGraph> graph(const SonarExplorer& explorer) {
  return std::make_shared<IndicatorGraph>(explorer.explorer().graph());
}
std::optional<double> route(const SonarExplorer& explorer) {
  const std::optional<Route> route = explorer.explorer().route();
  return route ? std::optional(route->length) : std::nullopt;
}
std::string known(const SonarExplorer& explorer, const Vec2& at) {
  const ConfigurationSpace& space = explorer.map().space();
  const Cell cell = space.frame().cell(at);
  if (cell.x < 0 || cell.y < 0 || cell.x >= space.width() || cell.y >= space.height()) return "unknown";
  const Known known = space.known(cell);
  return known == Known::free ? "free" : known == Known::wall ? "wall" : "unknown";
}
Ending ending(const SonarExplorer& explorer) { return explorer.ending(); }
std::string reason(const SonarExplorer& explorer) { return explorer.reason(); }
double walked(const SonarExplorer& explorer) { return explorer.walked(); }
int decisions(const SonarExplorer& explorer) { return static_cast<int>(explorer.explorer().state().decisions); }
bool proven(const SonarExplorer& explorer) { return explorer.explorer().proven(); }
std::string text(const SonarExplorer& explorer) {
  return fmt::format("sonar_explorer: run {}, {} indicators", explorer.explorer().state().run,
                     explorer.explorer().graph().size());
}

#define SONAR_EXPLORER "e = meander.indicator.sonar_explorer { goal = {4, 0} } "
#define DROVE                                                                                                   \
  SONAR_EXPLORER                                                                                                \
  "w = meander.world.new { bounds = {{-2, -2}, {6, 2}}, start = {0, 0, 0} } s = meander.sim.new { world = w } " \
  "s:drive { navigator = 'polar', guide = e:guide() } "

/// What its last run came to.
void bind_ending(lua_State* L) {
  Type<SonarExplorer>(L)
      .property<&ending>(PropertyDoc{.name = "ending",
                                     .text = "'driving', or how the last run ended: 'reached', "
                                             "'no_passable_direction', 'trapped', 'budget'. A drive that is cut off "
                                             "leaves it at 'driving'.",
                                     .example = DROVE "print(e.ending)"})
      .property<&reason>(
          PropertyDoc{.name = "reason", .text = "Why it ended, in words.", .example = DROVE "print(e.reason)"})
      .property<&walked>(
          PropertyDoc{.name = "walked", .text = "Driven in this run.", .unit = "m", .example = DROVE "print(e.walked)"})
      .property<&decisions>(
          PropertyDoc{.name = "decisions", .text = "Taken in all runs.", .example = DROVE "print(e.decisions)"})
      .property<&SonarExplorer::blocked>(PropertyDoc{.name = "blocked",
                                                     .text = "Ways on which it did not get through in this run.",
                                                     .example = DROVE "print(e.blocked)"})
      .property<&SonarExplorer::second_looks>(
          PropertyDoc{.name = "second_looks",
                      .text = "How often in this run it had no port left and looked again before it gave the goal up.",
                      .example = DROVE "print(e.second_looks)"})
      .property<&proven>(PropertyDoc{.name = "proven",
                                     .text = "Nothing unknown can shorten the route by more than eps.",
                                     .example = DROVE "print(e.proven)"});
}

}  // namespace

void bind_sonar_explorer(lua_State* L) {
  Module(L, "meander.indicator", "")
      .function<&make>(
          Doc{.name = "sonar_explorer",
              .text = "A robot's explorer: makes a map of what its sonars tell, reads indicators and ports off it, and "
                      "drives to its goal. What is known stays known from run to run.",
              .args = {{"options", "where to, by which rules, on which robot"}},
              .returns = "the explorer, whose guide any navigator follows",
              .errors = "no goal; a number out of range",
              .example = DROVE "print(e.ending, e.reason)"})
      .function<&open>(Doc{
          .name = "open_sonar_explorer",
          .text = "Reads a sonar explorer that sonar_explorer:save wrote: its next runs are as if nothing had been.",
          .args = {{"path", "the file"}, {"options", "functions that it calls, for they are not in the file"}},
          .returns = "the explorer, before its next run",
          .errors = "the file cannot be read, or is none",
          .example = DROVE "f = os.tmpname() e:save(f) print(meander.indicator.open_sonar_explorer(f))"});
  Type<SonarExplorer>(L, "Explores with indicators by sonar.")
      .method<&guide>(Doc{.name = "guide",
                          .text = "The guide that it is, for sim:drive. Each drive is a run.",
                          .returns = "the guide",
                          .example = SONAR_EXPLORER "print(e:guide())"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes what it knows, map and graph, with its goal and options, for "
                                 "open_sonar_explorer.",
                         .args = {{"path", "the file"}},
                         .errors = "the file cannot be written",
                         .example = DROVE "e:save(os.tmpname())"})
      .method<&graph>(Doc{.name = "graph",
                          .text = "A copy of its graph as it is now.",
                          .returns = "the graph",
                          .example = DROVE "show(e:graph():over(w))"})
      .method<&route>(Doc{.name = "route",
                          .text = "Length of the known route from the start of the last run to the goal.",
                          .returns = "length [m]; nil: none is known",
                          .example = DROVE "print(e:route())"})
      .method<&known>(Doc{.name = "known",
                          .text = "What its map knows of a point.",
                          .args = {{"at", "the point", "m"}},
                          .returns = "'free', 'wall' or 'unknown'",
                          .example = DROVE "print(e:known {1, 0})"})
      .text<&text>();
  bind_ending(L);
}

}  // namespace meander::script

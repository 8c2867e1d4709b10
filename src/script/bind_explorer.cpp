// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/explorer.hpp"

#include "indicator/indicator_text.hpp"
#include "render/draw_indicators.hpp"
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/indicator_objects.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/picture.hpp"

namespace meander {

std::size_t native_size(const Explorer& explorer) { return sizeof(Explorer) + native_size(explorer.graph()); }

}  // namespace meander

namespace meander::script {

struct ExplorerTable {
  Required<Vec2> goal;
  ExplorerOptions options;
  ExplorerListeners listeners;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ExplorerTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"goal", "m", "where to, in the odometry frame"}, o.goal);
  fields(o.options, visit);
  fields(o.listeners, visit);
}

struct PerceptTable {
  Required<Vec2> position;
  std::vector<SeenPortTable> ports;
  std::optional<double> back;
  double walked = 0;
  bool blocked = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PerceptTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"position", "m", "where the robot stands, in the odometry frame"}, o.position);
  visit(Field{"ports", "", "ways out of here: {direction, reach}"}, o.ports);
  visit(Field{"back", "rad", "direction of the way it came by; nil: it was set down here"}, o.back);
  visit(Field{"walked", "m", "since the last decision", 0, 1e9}, o.walked);
  visit(Field{"blocked", "", "it cannot go on, wherever this is"}, o.blocked);
}

struct DecisionTable {
  Ending ending = Ending::driving;
  std::string reason;
  std::optional<int> at;
  double direction = 0;
  std::optional<int> to;
  bool back = false;
  std::optional<int> target, target_port;
  int run = 0;
  double walked = 0;
  int decisions = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DecisionTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"ending", "", "'driving', or how the run ended"}, o.ending);
  visit(Field{"reason", "", "in words"}, o.reason);
  visit(Field{"at", "", "serial number of the indicator here"}, o.at);
  visit(Field{"direction", "rad", "in which to leave"}, o.direction);
  visit(Field{"to", "", "serial number of where that leads; nil: not known"}, o.to);
  visit(Field{"back", "", "turn round: back to the indicator it left"}, o.back);
  visit(Field{"target", "", "serial number of the indicator that it is after"}, o.target);
  visit(Field{"target_port", "", "the unknown port there; nil: the indicator itself"}, o.target_port);
  visit(Field{"run", "", "number of the run"}, o.run);
  visit(Field{"walked", "m", "in this run"}, o.walked);
  visit(Field{"decisions", "", "in this run"}, o.decisions);
}

struct PlacedTable {
  int serial = 0;
  double x = 0, y = 0;
  int run = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlacedTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"serial", "", "its number"}, o.serial);
  visit(Field{"x", "m", "in the odometry frame"}, o.x);
  visit(Field{"y", "m", "in the odometry frame"}, o.y);
  visit(Field{"run", "", "in which it was placed"}, o.run);
}

struct ExplorerStateTable {
  int run = 0, decisions = 0;
  double walked = 0;
  std::optional<int> at, start, at_goal;
  bool reopened = false, proven = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ExplorerStateTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"run", "", "number of the run, 0 before the first"}, o.run);
  visit(Field{"decisions", "", "in this run"}, o.decisions);
  visit(Field{"walked", "m", "in this run"}, o.walked);
  visit(Field{"at", "", "serial number of the indicator where it stands"}, o.at);
  visit(Field{"start", "", "serial number of that where the run began"}, o.start);
  visit(Field{"at_goal", "", "serial number of that at the goal, once it was reached"}, o.at_goal);
  visit(Field{"reopened", "", "in this run everything closed was opened once more"}, o.reopened);
  visit(Field{"proven", "", "nothing unknown can shorten the route by more than eps"}, o.proven);
}

namespace {

std::optional<int> serial(const std::optional<IndicatorId>& id) {
  return id ? std::optional(static_cast<int>(id->slot) + 1) : std::nullopt;
}

DecisionTable decision_table(const Explorer& explorer) {
  const Decision& d = explorer.decision();
  const ExplorerState& s = explorer.state();
  DecisionTable table{.ending = d.ending,
                      .reason = d.reason,
                      .at = serial(s.at),
                      .direction = d.direction,
                      .to = serial(d.to),
                      .back = d.back,
                      .target = {},
                      .target_port = {},
                      .run = s.run,
                      .walked = s.walked,
                      .decisions = s.in_run};
  if (s.at && d.ending == Ending::driving) table.target = serial(d.target.indicator);
  if (d.target.port >= 0) table.target_port = d.target.port + 1;
  return table;
}

std::shared_ptr<Explorer> make(const ExplorerTable& table) {
  auto explorer = std::make_shared<Explorer>(table.goal.value, table.options);
  listen(*explorer, table.listeners);
  return explorer;
}
std::shared_ptr<Explorer> open(const InputFile& file, const ExplorerListeners& functions) {
  auto explorer = std::make_shared<Explorer>(read_explorer(file.path));
  listen(*explorer, functions);
  return explorer;
}

void begin(Explorer& explorer, const Call& call) {
  const InUse in_use(call.L, &explorer, "explorer");
  explorer.begin();
}
DecisionTable step(Explorer& explorer, const PerceptTable& table, const Call& call) {
  const InUse in_use(call.L, &explorer, "explorer");
  Percept percept;
  percept.position = table.position.value;
  for (const SeenPortTable& port : table.ports) percept.ports.push_back({port.direction.value, port.reach});
  percept.back = table.back;
  percept.walked = table.walked;
  percept.blocked = table.blocked;
  explorer.step(percept);
  return decision_table(explorer);
}
void save(const Explorer& explorer, const OutputFile& file) { write_explorer(explorer, file.path); }

std::shared_ptr<IndicatorGraph> graph(const Explorer& explorer) {
  return std::make_shared<IndicatorGraph>(explorer.graph());
}
ExplorerStateTable state(const Explorer& explorer) {
  const ExplorerState& s = explorer.state();
  return {s.run, s.in_run, s.walked, serial(s.at), serial(s.start), serial(s.at_goal), s.reopened, explorer.proven()};
}
std::tuple<std::optional<std::vector<int>>, std::optional<double>> route(const Explorer& explorer) {
  const std::optional<Route> route = explorer.route();
  if (!route) return {};
  std::vector<int> serials;
  for (const int column : route->indicators) serials.push_back(column + 1);
  return {serials, route->length};
}
Vec2 goal(const Explorer& explorer) { return explorer.goal(); }
ExplorerOptions options(const Explorer& explorer) { return explorer.options(); }
DrawList picture(const Explorer& explorer) { return draw_indicators(explorer.graph()); }
std::string text(const Explorer& explorer) {
  const ExplorerOptions& o = explorer.options();
  const char* name = o.explorer == ExplorerKind::indicator ? to_string(o.rules) : to_string(o.explorer);
  return fmt::format("explorer \"{}\": run {}, {} indicators", name, explorer.state().run, explorer.graph().size());
}

}  // namespace

void listen(Explorer& explorer, const ExplorerListeners& listeners) {
  Explorer* const self = &explorer;
  if (listeners.on_indicator)
    explorer.on_indicator = [self, call = *listeners.on_indicator](IndicatorId id) {
      const Vec2 at = self->graph().get(id).position;
      call.call(PlacedTable{static_cast<int>(id.slot) + 1, at.x(), at.y(), self->state().run});
    };
  if (listeners.on_decision)
    explorer.on_decision = [self, call = *listeners.on_decision](const Decision&) { call.call(decision_table(*self)); };
}

#define EXPLORER "e = meander.indicator.explorer { goal = {5, 0} } "
#define STEPPED EXPLORER "d = e:step { position = {0, 0}, ports = { { direction = 0, reach = 3 } } } "

void bind_explorer(lua_State* L) {
  Module(L, "meander.indicator", "")
      .function<&make>(Doc{
          .name = "explorer",
          .text = "Explores with indicators: told at each crossing and dead end what there is, it says where to go.",
          .args = {{"options", "where to, by which rules"}},
          .returns = "the explorer",
          .errors = "a number out of range",
          .example = "print(meander.indicator.explorer { goal = {5, 5}, rules = 'repaired', on_indicator = print })"})
      .function<&open>(
          Doc{.name = "open_explorer",
              .text = "Reads an explorer that explorer:save wrote; it goes on as if nothing had been.",
              .args = {{"path", "the file"}, {"options", "functions that it calls, for they are not in the file"}},
              .returns = "the explorer",
              .errors = "the file cannot be read, or is none",
              .example = STEPPED "f = os.tmpname() e:save(f) print(meander.indicator.open_explorer(f))"});
  Type<Explorer>(L, "Decides where to go, and remembers the way as a graph of indicators.")
      .method<&begin>(Doc{.name = "begin",
                          .text = "A run begins: the robot was set down at its start. What is known stays known.",
                          .example = EXPLORER "e:begin() print(e.state.run)"})
      .method<&step>(Doc{.name = "step",
                         .text = "One decision, at a crossing, a dead end, an indicator, or where the way is closed.",
                         .args = {{"percept", "what the robot perceives there"}},
                         .returns = "ending, reason, at, direction, to, back, target, target_port, run, walked, "
                                    "decisions",
                         .errors = "the run is over",
                         .example = STEPPED "print(d.direction, d.reason)"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes it with its graph, for open_explorer.",
                         .args = {{"path", "the file"}},
                         .errors = "the file cannot be written",
                         .example = STEPPED "e:save(os.tmpname())"})
      .method<&graph>(Doc{.name = "graph",
                          .text = "A copy of its graph as it is now.",
                          .returns = "the graph",
                          .example = STEPPED "show(e:graph())"})
      .method<&route>(Doc{.name = "route",
                          .text = "The known route from the start of the last run to the goal.",
                          .returns = "serial numbers and length [m]; nil: none is known",
                          .returns_type = "list of integer or nil, number or nil",
                          .example = STEPPED "print(e:route())"})
      .property<&state>(PropertyDoc{.name = "state",
                                    .text = "Where it is in its work: {run, decisions, walked, at, start, at_goal, "
                                            "reopened, proven}.",
                                    .example = STEPPED "print(e.state.at, e.state.proven)"})
      .property<&goal>(
          PropertyDoc{.name = "goal", .text = "Where to.", .unit = "m", .example = EXPLORER "print(e.goal.x)"})
      .property<&options>(PropertyDoc{.name = "options",
                                      .text = "Its options, as they were given or left out.",
                                      .example = EXPLORER "print(e.options.rules, e.options.eps)"})
      .picture<&picture>()
      .text<&text>();
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/atomic_file.hpp"
#include "indicator/graph_export.hpp"
#include "indicator/indicator_storage.hpp"
#include "indicator/indicator_text.hpp"
#include "render/draw_indicators.hpp"
#include "render/draw_run.hpp"
#include "render/draw_world.hpp"
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/indicator_objects.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"
#include "script/picture.hpp"

namespace meander {

std::size_t native_size(const IndicatorGraph& graph) {
  return sizeof(IndicatorGraph) + graph.slots() * 400 + graph.links().size() * sizeof(Link);
}

}  // namespace meander

namespace meander::script {

struct LinkTable {
  int a = 0;
  std::optional<int> a_port;
  int b = 0;
  std::optional<int> b_port;
  double length = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LinkTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"a", "", "serial number of one end"}, o.a);
  visit(Field{"a_port", "", "its port; nil: by sight"}, o.a_port);
  visit(Field{"b", "", "serial number of the other end"}, o.b);
  visit(Field{"b_port", "", "its port; nil: by sight"}, o.b_port);
  visit(Field{"length", "m", "driven"}, o.length);
}

struct ContractedWayTable {
  int a = 0, b = 0;
  double length = 0;
  std::vector<int> between;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ContractedWayTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"a", "", "serial number of one end"}, o.a);
  visit(Field{"b", "", "serial number of the other end"}, o.b);
  visit(Field{"length", "m", "of the way"}, o.length);
  visit(Field{"between", "", "serial numbers of the indicators that it passes"}, o.between);
}

std::vector<PortTable> port_tables(const IndicatorGraph& graph, IndicatorId id) {
  std::vector<PortTable> tables;
  const Indicator& indicator = graph.get(id);
  for (std::size_t p = 0; p < indicator.ports.size(); ++p) {
    const Port& port = indicator.ports[p];
    PortTable table{port.direction, port.reach, port.state, {}, {}, {}};
    if (const auto far = graph.other_end({id, static_cast<int>(p)})) {
      table.to = static_cast<int>(far->indicator.slot) + 1;
      if (far->port >= 0) table.to_port = far->port + 1;
      table.length = graph.links()[static_cast<std::size_t>(port.link)].length;
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

namespace {

using Graph = std::shared_ptr<IndicatorGraph>;

Graph make() { return std::make_shared<IndicatorGraph>(); }
Graph open(const InputFile& file) { return std::make_shared<IndicatorGraph>(read_graph(file.path)); }
Graph from_text(const std::string& text) { return std::make_shared<IndicatorGraph>(graph_from_text(text)); }

IndicatorView place(const Graph& graph, const Vec2& position) { return {graph, graph->place(position)}; }
std::vector<IndicatorView> indicators(const Graph& graph) {
  std::vector<IndicatorView> all;
  for (const IndicatorId id : graph->ids()) all.push_back({graph, id});
  return all;
}
std::optional<IndicatorView> nearest(const Graph& graph, const Vec2& position) {
  const auto id = winner(*graph, position, 1e9);
  return id ? std::optional(IndicatorView{graph, *id}) : std::nullopt;
}
std::vector<LinkTable> links(const IndicatorGraph& graph) {
  std::vector<LinkTable> tables;
  for (const Link& link : graph.links()) {
    LinkTable table{
        static_cast<int>(link.a.indicator.slot) + 1, {}, static_cast<int>(link.b.indicator.slot) + 1, {}, link.length};
    if (link.a.port >= 0) table.a_port = link.a.port + 1;
    if (link.b.port >= 0) table.b_port = link.b.port + 1;
    tables.push_back(table);
  }
  return tables;
}
std::vector<ContractedWayTable> ways(const IndicatorGraph& graph) {
  std::vector<ContractedWayTable> tables;
  for (const ContractedWay& way : contracted(graph).ways) {
    ContractedWayTable table{static_cast<int>(way.a.slot) + 1, static_cast<int>(way.b.slot) + 1, way.length, {}};
    for (const IndicatorId id : way.between) table.between.push_back(static_cast<int>(id.slot) + 1);
    tables.push_back(std::move(table));
  }
  return tables;
}

void save(const IndicatorGraph& graph, const OutputFile& file) {
  const std::string& path = file.path;
  const std::string text = path.ends_with(".dot")       ? to_dot(graph)
                           : path.ends_with(".graphml") ? to_graphml(graph)
                           : path.ends_with(".json")    ? to_json(graph)
                                                        : to_text(graph);
  write_file_atomically(path, text);
}
std::string source(const IndicatorGraph& graph) { return to_text(graph); }

DrawList over(const IndicatorGraph& graph, const World& world, const std::optional<std::shared_ptr<RunRecord>>& drive) {
  DrawList list = draw_world(world);
  if (drive) {
    std::vector<Pose2> poses;
    for (const RunStep& step : (*drive)->run.steps) poses.push_back(step.pose_world);
    draw_track(list, {poses, (*drive)->run.robot_radius, {}, {}}, theme(Background::light));
  }
  draw_indicators(list, graph, theme(Background::light));
  return list;
}
DrawList picture(const IndicatorGraph& graph) { return draw_indicators(graph); }
std::string text(const IndicatorGraph& graph) {
  return fmt::format("indicator_graph: {} indicators, {} links", graph.size(), graph.links().size());
}
int length(const IndicatorGraph& graph) { return static_cast<int>(graph.size()); }

PortRef port_of(const IndicatorView& view, int port) {
  const PortRef ref{view.id, port - 1};
  view.graph->port(ref);
  return ref;
}
int add_port(const IndicatorView& view, double direction, const std::optional<double>& reach) {
  return view.graph->add_port(view.id, direction, reach.value_or(1)) + 1;
}
void link(const IndicatorView& view, const std::optional<int>& port, const IndicatorView& to,
          const std::optional<int>& to_port, double way) {
  if (view.graph != to.graph) fail("argument 'to': an indicator of the same graph expected");
  const auto end = [](const IndicatorView& v, const std::optional<int>& p) {
    return p ? port_of(v, *p) : PortRef{v.id};
  };
  view.graph->link(end(view, port), end(to, to_port), way);
}
void block(const IndicatorView& view, int port) { view.graph->block(port_of(view, port)); }
void give_up(const IndicatorView& view, int port) { view.graph->give_up(port_of(view, port)); }
void reopen(const IndicatorView& view, int port) { view.graph->reopen(port_of(view, port)); }
void remove(const IndicatorView& view) { view.graph->remove(view.id); }
Vec2 position(const IndicatorView& view) { return view.graph->get(view.id).position; }
int serial(const IndicatorView& view) { return static_cast<int>(view.id.slot) + 1; }
bool alive(const IndicatorView& view) { return view.graph->alive(view.id); }
std::vector<PortTable> ports(const IndicatorView& view) { return port_tables(*view.graph, view.id); }
std::string view_text(const IndicatorView& view) {
  if (!alive(view)) return fmt::format("removed indicator {}", serial(view));
  const Indicator& indicator = view.graph->get(view.id);
  return fmt::format("indicator {} at ({:.2f}, {:.2f}), {} ports", serial(view), indicator.position.x(),
                     indicator.position.y(), indicator.ports.size());
}
bool equal(const IndicatorView& a, const IndicatorView& b) { return a.graph == b.graph && a.id == b.id; }

#define GRAPH "g = meander.indicator.graph() a, b = g:place {0, 0}, g:place {3, 0} "
#define LINKED GRAPH "a:link(a:add_port(0), b, b:add_port(math.pi), 3.2) "

constexpr Arg kPort{"port", "its number"};

void bind_view(lua_State* L) {
  Type<IndicatorView>(L, "An indicator of a graph: a place with motion directions.")
      .method<&add_port>(Doc{
          .name = "add_port",
          .text = "Gives it one more motion direction, of which nothing is known yet.",
          .args = {{"direction", "in the odometry frame", "rad"}, {"reach", "seen open so far; 1 when left out", "m"}},
          .returns = "the port's number",
          .errors = "a number that is not finite",
          .example = GRAPH "print(a:add_port(0))"})
      .method<&link>(Doc{.name = "link",
                         .text = "Ties a port to one of another indicator; what they led to before is forgotten.",
                         .args = {{"port", "its own; nil: by sight, without a port"},
                                  {"to", "the other indicator"},
                                  {"to_port", "of that one; nil: by sight"},
                                  {"length", "of the way", "m"}},
                         .errors = "a length that is not above 0; another graph; the same port twice",
                         .example = GRAPH "a:link(a:add_port(0), b, b:add_port(math.pi), 3.2) a:link(nil, b, nil, 3)"})
      .method<&block>(Doc{.name = "block",
                          .text = "The way was found closed: its link goes, the ports at both ends count as blocked.",
                          .args = {kPort},
                          .errors = "there is no such port",
                          .example = LINKED "a:block(1) print(b.ports[1].state)"})
      .method<&give_up>(Doc{.name = "give_up",
                            .text = "The way leads nowhere: the port counts as a dead end.",
                            .args = {kPort},
                            .errors = "there is no such port",
                            .example = LINKED "b:give_up(1) print(b.ports[1].state)"})
      .method<&reopen>(Doc{.name = "reopen",
                           .text = "A blocked port or dead end is unknown again.",
                           .args = {kPort},
                           .errors = "there is no such port",
                           .example = LINKED "a:block(1) a:reopen(1) print(a.ports[1].state)"})
      .method<&remove>(Doc{.name = "remove",
                           .text = "Takes it out of the graph, with its links.",
                           .errors = "it was removed already",
                           .example = LINKED "a:remove() print(a.alive, #g)"})
      .property<&position>(
          PropertyDoc{.name = "position", .text = "Where it is.", .unit = "m", .example = GRAPH "print(b.position.x)"})
      .property<&serial>(
          PropertyDoc{.name = "serial", .text = "Its serial number.", .example = GRAPH "print(b.serial)"})
      .property<&alive>(PropertyDoc{.name = "alive", .text = "Is it in the graph?", .example = GRAPH "print(a.alive)"})
      .property<&ports>(PropertyDoc{.name = "ports",
                                    .text = "Its motion directions: {direction, reach, state, to, to_port, length}.",
                                    .example = LINKED "print(a.ports[1].to, a.ports[1].length)"})
      .text<&view_text>()
      .equal<&equal>();
}

}  // namespace

void bind_indicator(lua_State* L) {
  Module(L, "meander.indicator", "Exploration with indicators and the neural shortest path.")
      .function<&make>(Doc{.name = "graph",
                           .text = "An empty graph of indicators.",
                           .returns = "the graph",
                           .example = "g = meander.indicator.graph() print(g)"})
      .function<&open>(Doc{.name = "open_graph",
                           .text = "Reads a graph that graph:save wrote.",
                           .args = {{"path", "the file"}},
                           .returns = "the graph",
                           .errors = "the file cannot be read, or is none",
                           .example = LINKED "f = os.tmpname() g:save(f) print(meander.indicator.open_graph(f))"})
      .function<&from_text>(Doc{.name = "graph_from_text",
                                .text = "Reads a graph from the text that graph.source gives.",
                                .args = {{"text", "lines 'indicator', 'port', 'free', 'link'"}},
                                .returns = "the graph",
                                .errors = "a line that is wrong",
                                .example = LINKED "print(meander.indicator.graph_from_text(g.source))"});
  Type<IndicatorGraph>(L, "Indicators and the links between their ports.")
      .method<&place>(Doc{.name = "place",
                          .text = "Places an indicator.",
                          .args = {{"position", "where, in the odometry frame", "m"}},
                          .returns = "the indicator",
                          .errors = "a number that is not finite",
                          .example = GRAPH "print(a)"})
      .method<&nearest>(Doc{.name = "nearest",
                            .text = "The indicator nearest to a position: the storage's winner.",
                            .args = {{"position", "where", "m"}},
                            .returns = "the indicator, or nil in an empty graph",
                            .example = GRAPH "print(g:nearest {2, 0})"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes it: .dot, .graphml and .json for other programs, else for open_graph.",
                         .args = {{"path", "the file"}},
                         .errors = "the file cannot be written",
                         .example = LINKED "g:save(os.tmpname() .. '.dot')"})
      .method<&over>(
          Doc{.name = "over",
              .text = "The picture of a world with the graph over it, and the way that was driven.",
              .args = {{"world", "in whose frame the indicators are"}, {"run", "the drive; none when left out"}},
              .returns = "the picture, for show and save",
              .example = LINKED "show(g:over(meander.world.new {}))"})
      .property<&indicators>(PropertyDoc{.name = "indicators",
                                         .text = "All of them, in the order of their serial numbers.",
                                         .example = GRAPH "print(#g.indicators)"})
      .property<&links>(PropertyDoc{.name = "links",
                                    .text = "All of them: {a, a_port, b, b_port, length}.",
                                    .example = LINKED "print(g.links[1].length)"})
      .property<&ways>(PropertyDoc{.name = "ways",
                                   .text = "The links between crossings and ends, stops in corridors left out: {a, b, "
                                           "length, between}.",
                                   .example = LINKED "print(g.ways[1].length)"})
      .property<&source>(
          PropertyDoc{.name = "source", .text = "It as text, a line each.", .example = LINKED "print(g.source)"})
      .picture<&picture>()
      .length<&length>()
      .text<&text>();
  bind_view(L);
}

}  // namespace meander::script

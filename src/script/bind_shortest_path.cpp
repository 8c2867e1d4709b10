// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/dijkstra.hpp"
#include "indicator/hopfield_path.hpp"
#include "indicator/path_network.hpp"
#include "script/bind.hpp"
#include "script/indicator_objects.hpp"
#include "script/kit_module.hpp"

namespace meander::script {

enum class PathMethod { network, dijkstra, hopfield };

/// {a, b, length}
struct EdgeOption {
  RouteLinks::Edge edge;
};
template <>
struct Lua<EdgeOption> {
  static EdgeOption read(lua_State* L, int index, const Path& path) {
    const auto numbers = Lua<std::vector<double>>::read(L, index, path);
    if (numbers.size() != 3) expected(L, index, path, type());
    const auto serial = [&](double number) {
      if (!(number >= 1 && number <= 1e7) || number != static_cast<int>(number))
        fail("{}: whole numbers from 1 on expected as ends, got {}", path.text(), number);
      return static_cast<int>(number) - 1;
    };
    return {{serial(numbers[0]), serial(numbers[1]), numbers[2]}};
  }
  static std::string type() { return "{a, b, length}"; }
};

}  // namespace meander::script

namespace meander {
template <>
struct EnumNames<script::PathMethod> {
  static constexpr std::pair<script::PathMethod, const char*> entries[] = {{script::PathMethod::network, "network"},
                                                                           {script::PathMethod::dijkstra, "dijkstra"},
                                                                           {script::PathMethod::hopfield, "hopfield"}};
};
}  // namespace meander

namespace meander::script {

struct ShortestPathTable {
  Required<std::vector<EdgeOption>> links;
  Required<int> start, goal;
  PathMethod method = PathMethod::network;
  NetworkRows rows = NetworkRows::adaptive;
  HopfieldOptions hopfield;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ShortestPathTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"links", "m", "between indicators 1, 2, ...: two ends and the length of each"}, o.links);
  visit(Field{"start", "", "an indicator"}, o.start);
  visit(Field{"goal", "", "an indicator"}, o.goal);
  visit(Field{"method", "", "the paper's network, its oracle, or the relaxation that does not do"}, o.method);
  visit(Field{"rows", "", "of the network: as many as the paper says, or as many as it takes"}, o.rows);
  visit(Field{"hopfield", "", "weights of the relaxation"}, o.hopfield);
}

struct ExcitedTable {
  int indicator = 0;
  std::optional<int> from;
  double length = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ExcitedTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"indicator", "", "its column"}, o.indicator);
  visit(Field{"from", "", "column of the neuron of the row before that excited it"}, o.from);
  visit(Field{"length", "m", "of the route up to here"}, o.length);
}

struct CandidateTable {
  int rows = 0;
  double length = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, CandidateTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"rows", "", "of the layer that offers it"}, o.rows);
  visit(Field{"length", "m", "of its route"}, o.length);
}

struct NetworkRouteTable {
  std::optional<std::vector<int>> route;
  std::optional<double> length;
  bool truncated = false;
  int paper_rows = 0;
  std::vector<std::vector<ExcitedTable>> rows;
  std::vector<CandidateTable> candidates;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, NetworkRouteTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"route", "", "the indicators from start to goal; nil: none was found"}, o.route);
  visit(Field{"length", "m", "of the route"}, o.length);
  visit(Field{"truncated", "", "the network had not come to rest within its rows"}, o.truncated);
  visit(Field{"paper_rows", "", "as many as the paper's equation (1) says"}, o.paper_rows);
  visit(Field{"rows", "", "of the network: the neurons that fired"}, o.rows);
  visit(Field{"candidates", "", "what the layers offer to the selecting one"}, o.candidates);
}

namespace {

std::vector<int> serials(const std::vector<int>& columns) {
  std::vector<int> serials;
  for (const int column : columns) serials.push_back(column + 1);
  return serials;
}

void tell(NetworkRouteTable& table, const std::optional<Route>& route) {
  if (!route) return;
  table.route = serials(route->indicators);
  table.length = route->length;
}

void tell(NetworkRouteTable& table, const PathNetwork& network) {
  table.truncated = network.truncated();
  for (int r = 0; r < network.rows(); ++r) {
    std::vector<ExcitedTable>& row = table.rows.emplace_back();
    for (const PathNetwork::Excited& neuron : network.row(r)) {
      ExcitedTable& cell = row.emplace_back(ExcitedTable{neuron.indicator + 1, {}, neuron.potential});
      if (neuron.winner >= 0) cell.from = network.fired()[static_cast<std::size_t>(neuron.winner)].indicator + 1;
    }
  }
  for (const PathNetwork::Candidate& candidate : network.candidates())
    table.candidates.push_back({candidate.rows, candidate.length});
  if (const auto selected = network.selected()) tell(table, network.decrypt(*selected));
}

NetworkRouteTable shortest_path(const ShortestPathTable& table, const Call& call) {
  std::vector<RouteLinks::Edge> edges;
  int most = std::max(table.start.value, table.goal.value);
  for (const EdgeOption& option : table.links.value) {
    edges.push_back(option.edge);
    most = std::max({most, option.edge.a + 1, option.edge.b + 1});
  }
  if (table.start.value < 1 || table.goal.value < 1 || most > 10000000)
    fail("options 'start' and 'goal': indicators from 1 on expected, got {} and {}", table.start.value,
         table.goal.value);
  const RouteLinks links(most, edges);
  const int start = table.start.value - 1, goal = table.goal.value - 1;
  NetworkRouteTable result;
  result.paper_rows = PathNetwork::paper_rows(most);
  if (table.method == PathMethod::dijkstra) {
    tell(result, dijkstra_path(links, start, goal));
  } else if (table.method == PathMethod::hopfield) {
    if (most > 500) fail("method 'hopfield': at most 500 indicators expected, got {}", most);
    tell(result, hopfield_path(links, start, goal, table.hopfield, call.work()));
  } else {
    PathNetwork network;
    network.excite(links, start, goal, table.rows, call.work());
    tell(result, network);
  }
  return result;
}

}  // namespace

void bind_shortest_path(lua_State* L) {
  Module(L, "meander.indicator", "Exploration with indicators and the neural shortest path.")
      .function<&shortest_path>(Doc{
          .name = "shortest_path",
          .text = "The shortest route over linked indicators by the neural network, with all that fired in it.",
          .args = {{"options", "the links, from where to where, by what"}},
          .returns = "route, length, truncated, paper_rows, rows, candidates",
          .errors = "a length that is not above 0; an end that is no whole number from 1 on",
          .example = "r = meander.indicator.shortest_path { links = { {1, 2, 3}, {2, 3, 1}, {1, 3, 5} }, start = 1, "
                     "goal = 3 } print(r.length, #r.route)"});
}

}  // namespace meander::script

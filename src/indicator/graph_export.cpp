// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/graph_export.hpp"

#include <algorithm>

namespace meander {
namespace {

/// Writes each living indicator and each link.
template <class Node, class Edge>
void write_all(const IndicatorGraph& graph, Node node, Edge edge) {
  for (const IndicatorId id : graph.ids()) node(graph.get(id));
  for (const Link& link : graph.links()) edge(link);
}

int unknown_ports(const Indicator& indicator) {
  return static_cast<int>(std::count_if(indicator.ports.begin(), indicator.ports.end(),
                                        [](const Port& port) { return port.state == PortState::unknown; }));
}

std::string port_json(const Port& port) {
  return fmt::format(R"({{"direction":{},"reach":{},"state":"{}"}})", port.direction, port.reach,
                     to_string(port.state));
}

/// Follows corridors from one indicator that stays to the next.
class Contraction {
 public:
  Contraction(const IndicatorGraph& graph, const std::vector<IndicatorId>& keep)
      : graph_(graph), stays_(graph.slots(), 0), done_(graph.links().size(), 0) {
    for (const IndicatorId id : graph.ids()) {
      const Indicator& indicator = graph.get(id);
      const bool kept = std::find(keep.begin(), keep.end(), id) != keep.end();
      stays_[id.slot] = kept || indicator.links.size() != 2 || unknown_ports(indicator) > 0;
    }
  }

  ContractedGraph contract() {
    for (const IndicatorId id : graph_.ids())
      if (stays_[id.slot]) from(id);
    for (const IndicatorId id : graph_.ids())  // circles
      if (!stays_[id.slot] && !done_[static_cast<std::size_t>(graph_.get(id).links[0])]) from(id);
    std::sort(result_.indicators.begin(), result_.indicators.end());
    return std::move(result_);
  }

 private:
  void from(IndicatorId id) {
    stays_[id.slot] = 1;
    result_.indicators.push_back(id);
    for (const int link : graph_.get(id).links)
      if (!done_[static_cast<std::size_t>(link)]) follow(id, link);
  }
  void follow(IndicatorId start, int link) {
    ContractedWay way{start, start, 0, {}};
    for (;;) {
      const Link& step = graph_.links()[static_cast<std::size_t>(link)];
      done_[static_cast<std::size_t>(link)] = 1;
      way.length += step.length;
      way.b = step.a.indicator == way.b ? step.b.indicator : step.a.indicator;
      if (stays_[way.b.slot]) break;
      way.between.push_back(way.b);
      const std::vector<int>& links = graph_.get(way.b).links;
      link = links[0] == link ? links[1] : links[0];
    }
    result_.ways.push_back(std::move(way));
  }

  const IndicatorGraph& graph_;
  std::vector<char> stays_, done_;
  ContractedGraph result_;
};

}  // namespace

std::string to_dot(const IndicatorGraph& graph) {
  std::string text = "graph indicators {\n";
  const auto out = std::back_inserter(text);
  write_all(
      graph,
      [&](const Indicator& i) {
        fmt::format_to(out, "  {} [pos=\"{},{}!\"{}];\n", i.id.slot + 1, i.position.x(), i.position.y(),
                       unknown_ports(i) > 0 ? " style=dashed" : "");
      },
      [&](const Link& link) {
        fmt::format_to(out, "  {} -- {} [label=\"{:.2f}\" len={}];\n", link.a.indicator.slot + 1,
                       link.b.indicator.slot + 1, link.length, link.length);
      });
  return text + "}\n";
}

std::string to_graphml(const IndicatorGraph& graph) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
      "<key id=\"x\" for=\"node\" attr.name=\"x\" attr.type=\"double\"/>\n"
      "<key id=\"y\" for=\"node\" attr.name=\"y\" attr.type=\"double\"/>\n"
      "<key id=\"unknown\" for=\"node\" attr.name=\"unknown\" attr.type=\"int\"/>\n"
      "<key id=\"length\" for=\"edge\" attr.name=\"length\" attr.type=\"double\"/>\n"
      "<graph id=\"indicators\" edgedefault=\"undirected\">\n";
  const auto out = std::back_inserter(text);
  write_all(
      graph,
      [&](const Indicator& i) {
        fmt::format_to(out,
                       "<node id=\"n{}\"><data key=\"x\">{}</data><data key=\"y\">{}</data><data "
                       "key=\"unknown\">{}</data></node>\n",
                       i.id.slot + 1, i.position.x(), i.position.y(), unknown_ports(i));
      },
      [&](const Link& link) {
        fmt::format_to(out, "<edge source=\"n{}\" target=\"n{}\"><data key=\"length\">{}</data></edge>\n",
                       link.a.indicator.slot + 1, link.b.indicator.slot + 1, link.length);
      });
  return text + "</graph>\n</graphml>\n";
}

std::string to_json(const IndicatorGraph& graph) {
  std::string nodes, links;
  write_all(
      graph,
      [&](const Indicator& i) {
        std::string ports;
        for (const Port& port : i.ports) ports += (ports.empty() ? "" : ",") + port_json(port);
        nodes += fmt::format(R"({}{{"serial":{},"x":{},"y":{},"ports":[{}]}})", nodes.empty() ? "" : ",", i.id.slot + 1,
                             i.position.x(), i.position.y(), ports);
      },
      [&](const Link& link) {
        links += fmt::format(R"({}{{"a":{},"a_port":{},"b":{},"b_port":{},"length":{}}})", links.empty() ? "" : ",",
                             link.a.indicator.slot + 1, link.a.port + 1, link.b.indicator.slot + 1, link.b.port + 1,
                             link.length);
      });
  return "{\"indicators\":[" + nodes + "],\"links\":[" + links + "]}\n";
}

ContractedGraph contracted(const IndicatorGraph& graph, const std::vector<IndicatorId>& keep) {
  return Contraction(graph, keep).contract();
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/map_export.hpp"

#include <fmt/format.h>

namespace meander::topology {
namespace {

/// Each link once, from its smaller end.
template <class Visit>
void for_each_link(const CellPool& cells, Visit visit) {
  for (int cell = 0; cell < cells.slots(); ++cell)
    for (const Link& link : cells[cell].links)
      if (cell < link.to) visit(cell, link);
}

}  // namespace

std::string to_dot(const CellPool& cells) {
  std::string text = "graph places {\n  node [shape=point];\n";
  for (int cell = 0; cell < cells.slots(); ++cell)
    if (cells[cell].alive())
      text += fmt::format("  {} [pos=\"{},{}!\"];\n", cell, cells[cell].position.x(), cells[cell].position.y());
  for_each_link(cells, [&](int cell, const Link& link) {
    text +=
        fmt::format("  {} -- {} [weight={}{}];\n", cell, link.to, link.weight, link.suspended ? ", style=dashed" : "");
  });
  return text + "}\n";
}

std::string to_graphml(const CellPool& cells) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
      "  <key id=\"x\" for=\"node\" attr.name=\"x\" attr.type=\"double\"/>\n"
      "  <key id=\"y\" for=\"node\" attr.name=\"y\" attr.type=\"double\"/>\n"
      "  <key id=\"hits\" for=\"node\" attr.name=\"hits\" attr.type=\"long\"/>\n"
      "  <key id=\"weight\" for=\"edge\" attr.name=\"weight\" attr.type=\"double\"/>\n"
      "  <key id=\"suspended\" for=\"edge\" attr.name=\"suspended\" attr.type=\"boolean\"/>\n"
      "  <graph edgedefault=\"undirected\">\n";
  for (int cell = 0; cell < cells.slots(); ++cell)
    if (cells[cell].alive())
      text += fmt::format(
          "    <node id=\"n{}\"><data key=\"x\">{}</data><data key=\"y\">{}</data><data "
          "key=\"hits\">{}</data></node>\n",
          cell, cells[cell].position.x(), cells[cell].position.y(), cells[cell].hits);
  for_each_link(cells, [&](int cell, const Link& link) {
    text += fmt::format(
        "    <edge source=\"n{}\" target=\"n{}\"><data key=\"weight\">{}</data><data "
        "key=\"suspended\">{}</data></edge>\n",
        cell, link.to, link.weight, link.suspended);
  });
  return text + "  </graph>\n</graphml>\n";
}

}  // namespace meander::topology

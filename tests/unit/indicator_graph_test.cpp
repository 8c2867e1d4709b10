// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "indicator/cell_walk.hpp"
#include "indicator/graph_export.hpp"
#include "indicator/indicator_text.hpp"

namespace meander {
namespace {

/// What holds of every graph: links and ports tell the same, ends are alive, lengths are positive.
void expect_sound(const IndicatorGraph& graph) {
  std::size_t mentioned = 0;
  for (const IndicatorId id : graph.ids()) {
    const Indicator& indicator = graph.get(id);
    mentioned += indicator.links.size();
    for (const int link : indicator.links) {
      const Link& way = graph.links().at(static_cast<std::size_t>(link));
      EXPECT_TRUE(way.a.indicator == id || way.b.indicator == id);
    }
    for (int p = 0; p < static_cast<int>(indicator.ports.size()); ++p) {
      const Port& port = graph.port({id, p});
      EXPECT_EQ(port.state == PortState::linked, port.link >= 0);
      if (port.link < 0) continue;
      const Link& way = graph.links().at(static_cast<std::size_t>(port.link));
      EXPECT_TRUE(way.a == (PortRef{id, p}) || way.b == (PortRef{id, p}));
      EXPECT_EQ(graph.other_end(*graph.other_end({id, p})), (PortRef{id, p}));
    }
  }
  EXPECT_EQ(mentioned, 2 * graph.links().size());
  for (const Link& link : graph.links()) EXPECT_GT(link.length, 0);
}

PortRef any_port(const IndicatorGraph& graph, Stream& random) {
  const std::vector<IndicatorId> ids = graph.ids();
  const IndicatorId id = ids[static_cast<std::size_t>(random.below(static_cast<int>(ids.size())))];
  return {id, random.below(static_cast<int>(graph.get(id).ports.size()))};
}

IndicatorId place_with_ports(IndicatorGraph& graph, Stream& random) {
  const IndicatorId id = graph.place({random.uniform(0, 20), random.uniform(0, 20)});
  for (int p = random.below(4); p >= 0; --p) graph.add_port(id, random.uniform(-3, 3), random.uniform(0, 4));
  return id;
}

/// One edit at random; parallel links and links of an indicator with itself come about.
void edit(IndicatorGraph& graph, Stream& random) {
  if (graph.size() < 3 || random.chance(0.2)) {
    place_with_ports(graph, random);
    return;
  }
  const PortRef a = any_port(graph, random), b = any_port(graph, random);
  switch (random.below(8)) {
    case 0:
      graph.block(a, random.below(9));
      break;
    case 1:
      graph.give_up(a, random.below(9));
      break;
    case 2:
      graph.reopen(a);
      break;
    case 3:
      if (random.chance(0.3)) graph.remove(a.indicator);
      break;
    case 4:
      graph.set_seen(a, random.uniform(0, 3), random.below(3));
      break;
    case 5:
      if (a.indicator != b.indicator) graph.link({a.indicator}, {b.indicator}, random.uniform(0.1, 5));
      break;
    default:
      if (a != b) graph.link(a, b, random.uniform(0.1, 5));
  }
}

IndicatorGraph random_graph(std::uint64_t seed, int edits = 80) {
  Stream random(seed, "graph");
  IndicatorGraph graph;
  for (int i = 0; i < edits; ++i) edit(graph, random);
  return graph;
}

TEST(IndicatorGraph, StaysSoundUnderAnyEdits) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Stream random(seed, "edits");
    IndicatorGraph graph;
    for (int i = 0; i < 120; ++i) {
      edit(graph, random);
      expect_sound(graph);
    }
  }
}

TEST(IndicatorGraph, ABlockedLinkIsGoneAtBothEnds) {
  IndicatorGraph graph;
  const IndicatorId a = graph.place({0, 0}), b = graph.place({3, 0});
  const PortRef out{a, graph.add_port(a, 0, 3)}, in{b, graph.add_port(b, kPi, 3)};
  graph.link(out, in, 3);
  EXPECT_EQ(graph.other_end(out), in);
  graph.block(in, 4);
  EXPECT_TRUE(graph.links().empty());
  for (const PortRef& end : {out, in}) {
    EXPECT_EQ(graph.port(end).state, PortState::blocked);
    EXPECT_EQ(graph.port(end).closed_run, 4);
    EXPECT_EQ(graph.port(end).failures, 1);
  }
  graph.reopen(out);
  EXPECT_EQ(graph.port(out).state, PortState::unknown);
  graph.link(out, in, 3);  // it was driven again
  EXPECT_EQ(graph.port(in).failures, 0);
}

TEST(IndicatorGraph, HandlesOfRemovedIndicatorsAreRefused) {
  IndicatorGraph graph;
  const IndicatorId first = graph.place({0, 0});
  graph.remove(first);
  const IndicatorId second = graph.place({1, 1});
  EXPECT_EQ(second.slot, first.slot);
  EXPECT_FALSE(graph.alive(first));
  EXPECT_THROW(graph.get(first), StaleError);
  EXPECT_THROW(graph.remove(first), StaleError);
  EXPECT_THROW(graph.place({kPi, std::nan("")}), ArgumentError);
  EXPECT_THROW(graph.add_port(second, 0, -1), ArgumentError);
  const PortRef port{second, graph.add_port(second, 0, 1)};
  EXPECT_THROW(graph.link(port, port, 1), ArgumentError);
  EXPECT_THROW(graph.link(port, {second, graph.add_port(second, 1, 1)}, 0), ArgumentError);
  EXPECT_THROW(graph.port({second, 7}), ArgumentError);
}

TEST(IndicatorGraph, SurvivesWritingAndReading) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const IndicatorGraph graph = random_graph(seed);
    const std::string text = to_text(graph);
    const IndicatorGraph again = graph_from_text(text);
    expect_sound(again);
    EXPECT_EQ(to_text(again), text);
    EXPECT_EQ(again.ids(), graph.ids());
  }
}

TEST(IndicatorGraph, FilesThatAreWrongAreRefusedWithTheirLine) {
  const auto complaint = [](const std::string& text) {
    try {
      graph_from_text(text, "g.txt");
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const std::string head = "meander indicators 1\n", two = head + "indicator 1 1 0 0\nport 0 1 linked 0 0 0 0 0 0\n";
  EXPECT_EQ(complaint(""), "g.txt:0: not a file of this kind: 'meander indicators 1' expected in its first line");
  EXPECT_EQ(complaint("meander indicators 2\n"), "g.txt:1: version 2 is not known, only version 1 is");
  EXPECT_EQ(complaint(head + "indicator 2 1 0 0\n"), "g.txt:2: serial number 1 expected");
  EXPECT_EQ(complaint(head + "indicator 1 1 0 nan\n"), "g.txt:2: a finite number expected, got 'nan'");
  EXPECT_EQ(complaint(head + "port 0 1 unknown 0 0 0 0 0 0\n"), "g.txt:2: a port comes after its indicator");
  EXPECT_EQ(complaint(head + "indicator 1 1 0 0\nport 0 1 blockd 0 0 0 0 0 0\n"),
            "g.txt:3: unknown state 'blockd'; did you mean 'blocked'?");
  EXPECT_EQ(complaint(two + "end\n"), "g.txt:4: 1 ports are linked, but no link says where to");
  EXPECT_EQ(complaint(two + "link 1.1 1.1 3\n"), "g.txt:4: two ends expected");
  EXPECT_EQ(complaint(two + "link 1.1 2 3\n"), "g.txt:4: there is no indicator '2'");
  EXPECT_EQ(complaint(two + "link 1.1 3\n"), "g.txt:4: 'link END END LENGTH' expected");
  EXPECT_EQ(complaint(two), "g.txt:3: the file is cut off: 'end' expected in its last line");
  EXPECT_EQ(complaint(head), "g.txt:1: the file is cut off: 'end' expected in its last line");
  EXPECT_EQ(complaint(head + "end\nend\n"), "g.txt:3: nothing expected after 'end', got 'end'");
  EXPECT_EQ(complaint(head + "end\n"), "none");
}

TEST(IndicatorGraph, AFileThatIsCutOffAnywhereIsRefused) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::string text = to_text(random_graph(seed));
    for (std::size_t length = 0; length + 1 < text.size(); ++length)
      EXPECT_THROW(graph_from_text(text.substr(0, length)), FileError) << length;
  }
}

TEST(IndicatorGraph, SavingInTheMiddleChangesNothingThatFollows) {
  for (const ExplorerKind who : {ExplorerKind::indicator, ExplorerKind::tremaux, ExplorerKind::random_walk})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Labyrinth maze = make_labyrinth({.seed = seed, .columns = 9, .rows = 9, .loops = 0.1});
      ExplorerOptions options;
      options.explorer = who;
      Explorer whole(cell_center({8, 8}), options);
      Explorer parts = whole;
      for (int run = 0; run < 4; ++run) {
        const CellWalk one = walk_cells(maze, {0, 0}, whole), other = walk_cells(maze, {0, 0}, parts);
        ASSERT_EQ(one.visits, other.visits);
        parts = explorer_from_text(to_text(parts));
        EXPECT_EQ(to_text(parts), to_text(whole));
      }
    }
}

TEST(IndicatorGraph, ContractionLeavesCrossingsAndEndsAndKeepsLengths) {
  const Labyrinth maze = make_labyrinth({.seed = 4, .columns = 8, .rows = 8, .loops = 0.1});
  ExplorerOptions options;
  options.explorer = ExplorerKind::nearest;
  options.eps = 0;
  Explorer explorer(cell_center({20, 20}), options);  // not there: all is explored
  EXPECT_EQ(walk_cells(maze, {0, 0}, explorer).ending, Ending::no_passable_direction);
  const ContractedGraph small = contracted(explorer.graph());
  double whole = 0, kept = 0;
  for (const Link& link : explorer.graph().links()) whole += link.length;
  for (const ContractedWay& way : small.ways) kept += way.length;
  EXPECT_NEAR(whole, kept, 1e-9);
  for (const IndicatorId id : small.indicators) EXPECT_NE(explorer.graph().get(id).links.size(), 2u);
}

TEST(IndicatorGraph, ExportsAreWellFormed) {
  const IndicatorGraph graph = random_graph(7);
  const std::string dot = to_dot(graph), xml = to_graphml(graph), json = to_json(graph);
  EXPECT_TRUE(dot.starts_with("graph indicators {") && dot.ends_with("}\n"));
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
    return n;
  };
  EXPECT_EQ(count(xml, "<node "), graph.size());
  EXPECT_EQ(count(xml, "<edge "), graph.links().size());
  EXPECT_EQ(count(dot, " -- "), graph.links().size());
  EXPECT_EQ(count(json, "\"serial\""), graph.size());
  EXPECT_EQ(count(json, "{"), count(json, "}"));
}

TEST(IndicatorGraph, TheLowestFreeSlotIsTakenHoweverMany) {
  Stream random(3, "slots");
  IndicatorGraph graph;
  std::vector<IndicatorId> placed;
  for (int i = 0; i < 200'000; ++i) placed.push_back(graph.place({static_cast<double>(i), 0}));
  std::set<std::uint32_t> free;
  for (int i = 0; i < 2000; ++i) {
    const IndicatorId gone = placed[static_cast<std::size_t>(random.below(200'000))];
    if (graph.alive(gone) && random.chance(0.7)) {
      graph.remove(gone);
      free.insert(gone.slot);
    } else if (!free.empty()) {
      EXPECT_EQ(graph.place({0, 0}).slot, *free.begin());
      free.erase(free.begin());
    }
  }
}

TEST(IndicatorText, ARunThatIsOverIsOverWhenItIsReadAgain) {
  Explorer explorer({5, 0});
  const Percept there{.position = {5, 0}, .ports = {{0, 3}}};
  explorer.step(there);
  ASSERT_EQ(explorer.decision().ending, Ending::reached);
  Explorer read = explorer_from_text(to_text(explorer));
  EXPECT_EQ(read.decision().ending, Ending::reached);
  EXPECT_EQ(read.decision().reason, explorer.decision().reason);
  EXPECT_EQ(to_text(read), to_text(explorer));
  EXPECT_THROW(read.step(there), Error);
  read.begin();
  EXPECT_EQ(read.step(there).ending, Ending::reached);
}

}  // namespace
}  // namespace meander

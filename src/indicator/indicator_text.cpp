// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/indicator_text.hpp"

#include "base/atomic_file.hpp"
#include "base/names.hpp"
#include "base/text_file.hpp"
#include "indicator/graph_text.hpp"
#include "indicator/option_text.hpp"

namespace meander {
namespace {

constexpr const char* kGraph = "indicators";
constexpr const char* kExplorer = "explorer";
constexpr std::size_t kMostBytes = 64u << 20;

std::string place_text(const char* name, const std::optional<IndicatorId>& id, std::optional<int> port = {}) {
  std::string text = fmt::format("{} {}", name, id ? static_cast<long>(id->slot) + 1 : 0L);
  if (port) text += fmt::format(" {}", *port + 1);
  return text + "\n";
}

/// What a line "NAME SERIAL [PORT]" says; it is looked up once the graph is there.
struct PlaceLine {
  int serial = 0, port = 0;
};
PlaceLine read_place(TextLines& lines, const char* name, bool port) {
  if (!lines.next() || !lines.is(name) || lines.words().size() != (port ? 3u : 2u))
    lines.wrong("'{} SERIAL{}' expected", name, port ? " PORT" : "");
  return {lines.integer(1, 0, 1 << 30), port ? lines.integer(2, 0, 1 << 30) : 0};
}

std::optional<IndicatorId> place_in(const IndicatorGraph& graph, const PlaceLine& place, const TextLines& lines) {
  if (place.serial == 0) return std::nullopt;
  const Indicator* indicator = graph.in_slot(static_cast<std::size_t>(place.serial) - 1);
  if (!indicator) lines.wrong("there is no indicator {}", place.serial);
  if (place.port > static_cast<int>(indicator->ports.size()))
    lines.wrong("indicator {} has no port {}", place.serial, place.port);
  return indicator->id;
}

struct Places {
  PlaceLine at, left_by, start, at_goal, to;
};

/// What the next step asks of the last decision: whether the run has ended, why, and where the robot is on its way to.
std::string decision_line(const Explorer& explorer) {
  const Decision& last = explorer.decision();
  const bool alive = last.to && explorer.graph().alive(*last.to);
  return fmt::format("decision {} {} {}\n", alive ? last.to->slot + 1 : 0, to_string(last.ending), last.reason);
}

Decision read_decision(TextLines& lines, Places& places) {
  if (!lines.next() || !lines.is("decision") || lines.words().size() < 3)
    lines.wrong("'decision SERIAL ENDING REASON' expected");
  places.to = {lines.integer(1, 0, 1 << 30), 0};
  const auto ending = enum_from<Ending>(lines.words()[2]);
  if (!ending) lines.wrong("unknown ending '{}'{}", lines.shown(2), did_you_mean(lines.shown(2), enum_names<Ending>()));
  Decision last;
  last.ending = *ending;
  for (std::size_t word = 3; word < lines.words().size(); ++word)
    last.reason += (word > 3 ? " " : "") + std::string(lines.words()[word]);
  return last;
}

Places read_state(TextLines& lines, ExplorerState& state) {
  if (!lines.next() || !lines.is("state")) lines.wrong("'state' expected");
  lines.count(8, "state RUN DECISIONS IN_RUN WALKED IDLE REOPENED FRESH");
  constexpr int most = std::numeric_limits<int>::max() / 2;
  state.run = lines.integer(1, 0, most);
  state.decisions = lines.integer<std::uint64_t>(2, 0, std::uint64_t{1} << 60);
  state.in_run = lines.integer(3, 0, most);
  state.walked = lines.number(4);
  state.idle = lines.integer(5, 0, most);
  state.reopened = lines.integer(6, 0, 1) == 1;
  state.fresh = lines.integer(7, 0, 1) == 1;
  const PlaceLine at = read_place(lines, "at", true), left_by = read_place(lines, "left_by", true);
  const PlaceLine start = read_place(lines, "start", false);
  return {at, left_by, start, read_place(lines, "at_goal", false), {}};
}

void put(ExplorerState& state, const Places& places, const IndicatorGraph& graph, const TextLines& lines) {
  state.at = place_in(graph, places.at, lines);
  if (state.at && places.at.port > 0) state.came_by = places.at.port - 1;
  if (const auto left = place_in(graph, places.left_by, lines)) state.left_by = PortRef{*left, places.left_by.port - 1};
  state.start = place_in(graph, places.start, lines);
  state.at_goal = place_in(graph, places.at_goal, lines);
  if (state.at.has_value() != state.start.has_value() || (state.left_by && !state.at))
    lines.wrong("'at', 'left_by' and 'start' do not belong together");
}

}  // namespace

void check_header(TextLines& lines, const char* what) {
  if (!lines.next() || lines.words().size() != 3 || !lines.is("meander") || lines.words()[1] != what)
    lines.wrong("not a file of this kind: 'meander {} 1' expected in its first line", what);
  if (lines.words()[2] != "1") lines.wrong("version {} is not known, only version 1 is", lines.shown(2));
}

std::string to_text(const IndicatorGraph& graph) { return fmt::format("meander {} 1\n", kGraph) + graph_lines(graph); }

IndicatorGraph graph_from_text(const std::string& text, const std::string& path) {
  TextLines lines(text, path);
  check_header(lines, kGraph);
  return read_graph_lines(lines);
}

std::string state_lines(const Explorer& explorer) {
  const ExplorerState& s = explorer.state();
  std::string text = fmt::format("state {} {} {} {} {} {} {}\n", s.run, s.decisions, s.in_run, s.walked, s.idle,
                                 int{s.reopened}, int{s.fresh});
  text += place_text("at", s.at, s.came_by.value_or(-1));
  text += place_text("left_by", s.left_by ? std::optional(s.left_by->indicator) : std::nullopt,
                     s.left_by ? s.left_by->port : -1);
  text += place_text("start", s.start) + place_text("at_goal", s.at_goal) + decision_line(explorer);
  return text + graph_lines(explorer.graph());
}

void read_state_lines(TextLines& lines, Explorer& explorer) {
  ExplorerState state;
  Places places = read_state(lines, state);
  Decision last = read_decision(lines, places);
  IndicatorGraph graph = read_graph_lines(lines);
  put(state, places, graph, lines);
  last.to = place_in(graph, places.to, lines);
  explorer.restore(std::move(graph), state, std::move(last));
}

std::string goal_line(const Vec2& goal) { return fmt::format("goal {} {}\n", goal.x(), goal.y()); }
Vec2 read_goal_line(TextLines& lines) {
  if (!lines.next() || !lines.is("goal")) lines.wrong("'goal X Y' expected");
  lines.count(3, "goal X Y");
  return {lines.number(1), lines.number(2)};
}

std::string to_text(const Explorer& explorer) {
  return fmt::format("meander {} 1\n", kExplorer) + goal_line(explorer.goal()) + option_lines(explorer.options()) +
         state_lines(explorer);
}

Explorer explorer_from_text(const std::string& text, const std::string& path) {
  TextLines lines(text, path);
  check_header(lines, kExplorer);
  const Vec2 goal = read_goal_line(lines);
  ExplorerOptions options;
  read_option_lines(lines, options);
  check_options(lines, options);
  Explorer explorer(goal, options);
  read_state_lines(lines, explorer);
  return explorer;
}

void write_graph(const IndicatorGraph& graph, const std::string& path) { write_file_atomically(path, to_text(graph)); }
IndicatorGraph read_graph(const std::string& path) { return graph_from_text(read_text_file(path, kMostBytes), path); }
void write_explorer(const Explorer& explorer, const std::string& path) {
  write_file_atomically(path, to_text(explorer));
}
Explorer read_explorer(const std::string& path) { return explorer_from_text(read_text_file(path, kMostBytes), path); }

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <map>

#include "grid/labyrinth.hpp"
#include "indicator/explorer.hpp"
#include "script/kit_function.hpp"
#include "script/kit_object.hpp"
#include "script/kit_options.hpp"

namespace meander {

std::size_t native_size(const IndicatorGraph& graph);
std::size_t native_size(const Explorer& explorer);
std::size_t native_size(const Labyrinth& labyrinth);

}  // namespace meander

namespace meander::script {

/// An indicator, as scripts hold it.
struct IndicatorView {
  std::shared_ptr<IndicatorGraph> graph;
  IndicatorId id;
};

template <>
struct ObjectName<IndicatorGraph> {
  static constexpr const char* value = "indicator_graph";
};
template <>
struct ObjectName<IndicatorView> {
  static constexpr const char* value = "indicator";
};
template <>
struct ObjectName<Explorer> {
  static constexpr const char* value = "explorer";
};
template <>
struct ObjectName<Labyrinth> {
  static constexpr const char* value = "labyrinth";
};

/// A port, in tables.
struct PortTable {
  double direction = 0, reach = 0;
  PortState state = PortState::unknown;
  std::optional<int> to, to_port;
  std::optional<double> length;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PortTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"direction", "rad", "in the odometry frame"}, o.direction);
  visit(Field{"reach", "m", "seen open so far"}, o.reach);
  visit(Field{"state", "", "what is known of it"}, o.state);
  visit(Field{"to", "", "serial number of the indicator that it leads to"}, o.to);
  visit(Field{"to_port", "", "the port of that one"}, o.to_port);
  visit(Field{"length", "m", "of the link"}, o.length);
}
/// Functions of a script that an explorer calls.
struct ExplorerListeners {
  std::optional<Function> on_indicator, on_decision;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ExplorerListeners>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"on_indicator", "", "function(indicator), called when one was placed: {serial, x, y, run}"},
        o.on_indicator);
  visit(Field{"on_decision", "", "function(decision), called after each step"}, o.on_decision);
}
/// The functions see the explorer as it is when they are called. It owns them.
void listen(Explorer& explorer, const ExplorerListeners& listeners);

std::vector<PortTable> port_tables(const IndicatorGraph& graph, IndicatorId id);

/// What is seen where the robot stands.
struct SeenPortTable {
  Required<double> direction;
  double reach = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SeenPortTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"direction", "rad", "in the odometry frame"}, o.direction);
  visit(Field{"reach", "m", "open so far, as far as it can be seen", 0, 1e9}, o.reach);
}

}  // namespace meander::script

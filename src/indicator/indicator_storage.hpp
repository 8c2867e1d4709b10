// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "indicator/indicator_graph.hpp"
#include "indicator/path_network.hpp"

namespace meander {

/// The storage of the key points, [DG] Figure 7: a Kohonen layer whose neurons hold the places (x, y) of the
/// indicators. The neuron that is nearest to the robot wins: its indicator is the current one; ties go to the lower
/// serial number. None: no indicator within `reach` [m].
std::optional<IndicatorId> winner(const IndicatorGraph& graph, const Vec2& position, double reach);

/// W_ij of [DG] Figure 7: the port by which the robot leaves indicator `from` for its neighbour `to`, that of the
/// shortest link between them. [DG+] Of links of equal length, the one whose direction is the least angle. None: they
/// are no neighbours. A link by sight has port -1.
std::optional<PortRef> way_out(const IndicatorGraph& graph, IndicatorId from, IndicatorId to);

/// Direction from `from` to where the robot leaves it for `to`: of the port, or of the neighbour itself [rad].
double motion_direction(const IndicatorGraph& graph, const PortRef& out, IndicatorId to);

/// The decryption block, [DG] Figures 8 and 9: of P_1 .. P_N the current indicator, of S_1 .. S_N the next on the
/// route. None: the current one is the last, or not on the route.
std::optional<int> next_on_route(const Route& route, int current);

}  // namespace meander

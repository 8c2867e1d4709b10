// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/polar_own.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "base/elementary.hpp"

namespace meander::script {
namespace {

constexpr float kNone = -400;  ///< decades: less than any double

/// The decadic logarithm; of less than the least normal number, that one's.
float decades(double x) {
  return static_cast<float>(logarithm(std::max(x, std::numeric_limits<double>::min())) / std::numbers::ln10);
}

OwnWeights own_weights(const Function& function) {
  return [function](const PolarLayout& layout, int ring) {
    const bool rim = ring == layout.rings() - 1;
    const auto w = function.get<PolarRingWeights>(PolarRingView{.ring = ring + 1,
                                                                .rings = layout.rings(),
                                                                .sectors = layout.sectors(),
                                                                .radius = layout.radius(ring),
                                                                .inner = layout.radius(ring - 1),
                                                                .outer = layout.radius(rim ? ring : ring + 1),
                                                                .spacing = layout.spacing()});
    const double neighbours =
        w.inward.value + w.outward.value + 2 * (w.lateral.value + w.inward_diagonal + w.outward_diagonal);
    return RingWeights{.inward = w.inward.value,
                       .outward = w.outward.value,
                       .lateral = w.lateral.value,
                       .inward_diagonal = w.inward_diagonal,
                       .outward_diagonal = w.outward_diagonal,
                       .total = neighbours + w.leak.value};
  };
}

OwnObjective own_objective(const Function& function) {
  return [function](const MotionCandidate& candidate) { return function.get<double>(candidate_view(candidate)); };
}

/// Ring and sector from the top of the stack, or nothing.
std::optional<PolarSubgoal> read_subgoal(lua_State* L, const Path& path, const PolarState& state) {
  const auto ring = Lua<std::optional<int>>::read(L, -2, path), sector = Lua<std::optional<int>>::read(L, -1, path);
  lua_pop(L, 2);
  if (!ring) return std::nullopt;
  const PolarLayout& layout = state.layout;
  if (!sector || *ring < 1 || *ring > layout.rings() || *sector < 1 || *sector > layout.sectors())
    fail("{}: ring from 1 to {} and sector from 1 to {} expected, got ring {} and {}", path.text(), layout.rings(),
         layout.sectors(), *ring, sector ? fmt::format("sector {}", *sector) : std::string("no sector"));
  PolarSubgoal subgoal{.sector = *sector - 1, .ring = *ring - 1};
  subgoal.position = layout.position(subgoal.ring, subgoal.sector);
  return subgoal;
}

OwnSubgoal own_subgoal(const Function& function) {
  return [function](const PolarState& state) {
    PolarStateView view{.rings = state.layout.rings(),
                        .sectors = state.layout.sectors(),
                        .target = state.target.x(),
                        .target_ring = state.target_ring + 1,
                        .previous = std::nullopt,
                        .radii = state.layout.radii(),
                        .bearings = sector_bearings(state.layout),
                        .activation = log_activation(state.layout, state.solver)};
    if (state.previous) view.previous = *state.previous + 1;
    return read_subgoal(function.invoke(2, view), function.result_path(), state);
  };
}

}  // namespace

Matrix log_activation(const PolarLayout& layout, const PolarSolver& solver) {
  auto cells = std::make_shared<std::vector<float>>();
  for (int ring = 0; ring < layout.rings(); ++ring)
    for (int sector = 0; sector < layout.sectors(); ++sector) {
      const double activation = solver.activation(ring, sector);
      cells->push_back(activation > 0 ? decades(activation) : kNone);
    }
  return {std::move(cells), static_cast<std::size_t>(layout.rings()), static_cast<std::size_t>(layout.sectors())};
}

std::vector<double> sector_bearings(const PolarLayout& layout) {
  std::vector<double> bearings;
  for (int sector = 0; sector < layout.sectors(); ++sector) bearings.push_back(layout.bearing(sector));
  return bearings;
}

PolarCandidateView candidate_view(const MotionCandidate& c) {
  return {.v = c.command.v,
          .w = c.command.w,
          .x = c.end.x,
          .y = c.end.y,
          .heading = c.end.heading,
          .distance = c.distance,
          .heading_error = c.heading_error,
          .samples = c.samples,
          .hard = c.hard,
          .soft = c.soft,
          .near = c.near};
}

PolarParts polar_parts(const PolarOwnTable& own) {
  PolarParts parts;
  if (own.weights) parts.weights = own_weights(*own.weights);
  if (own.objective) parts.objective = own_objective(*own.objective);
  if (own.subgoal) parts.subgoal = own_subgoal(*own.subgoal);
  return parts;
}

}  // namespace meander::script

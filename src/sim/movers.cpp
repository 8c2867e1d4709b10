// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sim/movers.hpp"

#include <algorithm>

namespace meander {
namespace {

std::size_t station_count(const Mover& mover) { return mover.waypoints.size() + 1; }

const Vec2& station(const Mover& mover, std::size_t index) {
  return index == 0 ? mover.disc.center : mover.waypoints[index - 1];
}

Stream own_stream(std::uint64_t seed, Id id) {
  return Stream(seed, fmt::format("mover {}.{}", id.slot, id.generation));
}

bool robot_ahead(const Vec2& position, const Vec2& direction, double radius, std::span<const Pole> robots) {
  static const double kAhead = sin_cos(kYieldAngle).cos;
  for (const Pole& robot : robots) {
    const Vec2 to = robot.disc.center - position;
    const double distance = to.norm();
    if (distance - radius - robot.disc.radius < kYieldMargin && to.dot(direction) > kAhead * distance) return true;
  }
  return false;
}

/// Share of the way until the disc meets the bounds from inside; outside it may only come back.
double way_to_bounds(const Vec2& from, const Vec2& by, double radius, const Box& bounds) {
  double share = kFreeWay;
  for (int axis = 0; axis < 2; ++axis) {
    const double gap = by[axis] > 0 ? bounds.high[axis] - radius - from[axis] : from[axis] - radius - bounds.low[axis];
    const double way = std::abs(by[axis]);
    if (way > 0 && gap < way) share = std::min(share, std::max(0.0, gap / way));
  }
  return share;
}

}  // namespace

struct Movers::Place {
  const ShapeIndex& walls;
  const Box& bounds;
  std::span<const Pole> robots;
};

void Movers::restart(std::uint64_t seed) {
  seed_ = seed;
  states_.clear();
  traits_.clear();
}

void Movers::follow(const World& world) {
  std::vector<MoverState> states;
  std::vector<Traits> traits;
  for (const Id id : world.ids()) {
    const auto* mover = std::get_if<Mover>(&world.item(id));
    if (!mover) continue;
    const auto known = std::find_if(states_.begin(), states_.end(), [&](const MoverState& s) { return s.id == id; });
    const auto index = static_cast<std::size_t>(known - states_.begin());
    if (known != states_.end() && traits_[index].item == *mover) {
      states.push_back(*known);
      traits.push_back(traits_[index]);
    } else {
      traits.push_back({.item = *mover, .stream = own_stream(seed_, id)});
      states.push_back({.id = id,
                        .position = mover->disc.center,
                        .heading = traits.back().stream.uniform(-kPi, kPi),
                        .next = mover->waypoints.empty() ? 0u : 1u});
    }
  }
  states_ = std::move(states);
  traits_ = std::move(traits);
  look_again();
}

void Movers::look_again() {
  for (Traits& traits : traits_) traits.room = 0;
}

void Movers::wander(double dt) {
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (traits_[i].item.motion == Motion::random_walk)
      states_[i].heading = wrap_angle(states_[i].heading + traits_[i].stream.normal(0, kWander * std::sqrt(dt)));
}

void Movers::advance(double dt, const ShapeIndex& walls, const Box& bounds, std::span<const Pole> robots) {
  const Place place{walls, bounds, robots};
  for (std::size_t i = 0; i < states_.size(); ++i) {
    traits_[i].stride = {0, 0};
    const double budget = traits_[i].item.speed * dt;
    if (traits_[i].item.motion == Motion::waypoints)
      tour(states_[i], traits_[i], budget, place);
    else
      walk(states_[i], traits_[i], budget, place);
  }
}

void Movers::tour(MoverState& state, Traits& traits, double budget, const Place& place) {
  // Stations may coincide: one round at most in one go.
  for (std::size_t legs = station_count(traits.item); legs > 0 && budget > 0; --legs) {
    const Vec2 to = station(traits.item, state.next) - state.position;
    const double distance = to.norm();
    if (distance > budget) {
      go(state, traits, to * (budget / distance), place);
      return;
    }
    if (distance > 0 && !go(state, traits, to, place)) return;
    budget -= distance;
    state.next = (state.next + 1) % station_count(traits.item);
  }
}

void Movers::walk(MoverState& state, Traits& traits, double budget, const Place& place) {
  const SinCos direction = sin_cos(state.heading);
  const bool free = go(state, traits, Vec2{budget * direction.cos, budget * direction.sin}, place);
  if (free || (state.waiting && traits.stride.isZero())) return;  // a robot is ahead: wait, do not turn
  state.heading = traits.stream.uniform(-kPi, kPi);
}

bool Movers::go(MoverState& state, Traits& traits, const Vec2& by, const Place& place) {
  const double length = by.norm();
  if (length == 0) return true;
  if (traits.item.yields && robot_ahead(state.position, by / length, traits.item.disc.radius, place.robots)) {
    state.waiting = true;
    return false;
  }
  traits.stride = by;
  const double share = free_share(state, traits, by, place);
  state.waiting = share < 1;
  state.position += std::min(share, 1.0) * by;
  traits.room -= length;
  return share >= 1;
}

double Movers::free_share(const MoverState& state, Traits& traits, const Vec2& by, const Place& place) {
  const double radius = traits.item.disc.radius;
  const double length = by.norm();
  double share = kFreeWay;
  if (traits.item.motion == Motion::random_walk) share = way_to_bounds(state.position, by, radius, place.bounds);
  for (const Pole& robot : place.robots)
    share =
        std::min(share, way_to_point(state.position, by, radius + robot.disc.radius + kContactSkin, robot.disc.center));
  if (traits.room > length + kContactSkin) return share;
  constexpr double kLook = 1;  // [m] of way for which one look at the walls may last
  traits.room = place.walls.distance(state.position, radius + kLook) - radius;
  if (traits.room > length + kContactSkin) return share;
  near_.gather(place.walls, state.position, radius + length + kContactGap);
  return std::min(share, near_.way(state.position, by, radius));
}

void Movers::add_to(Hash& hash) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const MoverState& state = states_[i];
    hash.add(std::uint64_t{state.id.slot})
        .add(std::uint64_t{state.id.generation})
        .add(state.position.x())
        .add(state.position.y())
        .add(state.heading)
        .add(std::uint64_t{state.next})
        .add(std::uint64_t{state.waiting});
    traits_[i].stream.add_to(hash);
  }
}

}  // namespace meander

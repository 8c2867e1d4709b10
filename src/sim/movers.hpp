// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "base/random.hpp"
#include "sensor/scene.hpp"
#include "sim/contact.hpp"
#include "sim/mover_state.hpp"
#include "world/world.hpp"

namespace meander {

/// A mover that yields stops while a robot is nearer than this, hull to hull [m], within this angle of its way [rad].
inline constexpr double kYieldMargin = 0.5;
inline constexpr double kYieldAngle = 1.0471975511965976;
/// How much the heading of a random walk wanders [rad per root second].
inline constexpr double kWander = 0.3;

/// What moves by itself: discs on a round of waypoints or on a random walk. They pass through neither walls nor robots;
/// among each other they do not mind.
class Movers {
 public:
  /// Takes over the movers of the world as they are now: new ones start, edited ones start again, the rest go on.
  void follow(const World& world);
  /// Forgets all; the next follow() starts them anew. Each mover has its own random stream of this seed.
  void restart(std::uint64_t seed);

  /// New headings of the random walks for a cycle of `dt` seconds.
  void wander(double dt);
  /// `dt` seconds of motion. `robots` are the robots' discs.
  void advance(double dt, const ShapeIndex& walls, const Box& bounds, std::span<const Pole> robots);
  /// Walls may have changed: forget how much room there was.
  void look_again();

  std::span<const MoverState> states() const { return states_; }
  double radius(std::size_t mover) const { return traits_[mover].item.disc.radius; }
  /// The way the mover wanted to go last [m]; zero while it yields.
  const Vec2& stride(std::size_t mover) const { return traits_[mover].stride; }
  void add_to(Hash& hash) const;

 private:
  struct Traits {
    Mover item;
    Stream stream;
    double room = 0;  ///< no wall is nearer to the hull [m]
    Vec2 stride{0, 0};
  };
  struct Place;  ///< what advance() is told about the surroundings

  void tour(MoverState& state, Traits& traits, double budget, const Place& place);
  void walk(MoverState& state, Traits& traits, double budget, const Place& place);
  /// Goes along `by` as far as it is free; returns whether the whole way was.
  bool go(MoverState& state, Traits& traits, const Vec2& by, const Place& place);
  double free_share(const MoverState& state, Traits& traits, const Vec2& by, const Place& place);

  std::uint64_t seed_ = 0;
  std::vector<MoverState> states_;
  std::vector<Traits> traits_;
  Surroundings near_;
};

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "geometry/pose.hpp"

namespace meander {

/// How the body moves: along its heading and turning, or in any direction.
enum class DriveKind { unicycle, omnidirectional };
template <>
struct EnumNames<DriveKind> {
  static constexpr std::pair<DriveKind, const char*> entries[] = {{DriveKind::unicycle, "unicycle"},
                                                                  {DriveKind::omnidirectional, "omnidirectional"}};
};

/// Round body with its limits.
struct Body {
  double radius = 0.2667;
  double v_max = 0.6096;
  double v_min = 0;
  double w_max = 0.7853981633974483;
  double a_v = 0.762;
  double a_w = 1.0471975511965976;
  DriveKind drive = DriveKind::unicycle;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, Body>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"radius", "m", "radius of the round body", 0.01, 10}, o.radius);
  visit(Field{"v_max", "m/s", "largest forward speed", 0, 100}, o.v_max);
  visit(Field{"v_min", "m/s", "least speed; 0: no reversing", -100, 0}, o.v_min);
  visit(Field{"w_max", "rad/s", "largest turning rate", 0, 100}, o.w_max);
  visit(Field{"a_v", "m/s^2", "largest acceleration and braking", 1e-3, 1000}, o.a_v);
  visit(Field{"a_w", "rad/s^2", "largest turning acceleration", 1e-3, 1000}, o.a_w);
  visit(Field{"drive", "", "unicycle: forward and turning; omnidirectional: in any direction"}, o.drive);
}

/// Where the transducers sit: evenly spaced on a circle, the first forward, counter-clockwise.
struct RingLayout {
  int count = 16;
  double radius = 0.23;  ///< of the circle the transducers sit on [m]
  double first = 0;      ///< bearing of the first [rad]
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RingLayout>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"count", "", "number of transducers", 0, 1024}, o.count);
  visit(Field{"radius", "m", "radius of the circle that the transducers sit on", 0, 10}, o.radius);
  visit(Field{"first", "rad", "bearing of the first transducer", -7, 7}, o.first);
}

/// A kind of robot: body, sensor places, control period.
struct Platform {
  std::string name = "nomad200";
  Body body;
  RingLayout sonar;
  RingLayout bumper{20, 0.2667, 0};
  RingLayout whisker{0, 0.15, 0};
  RingLayout light{0, 0.15, 0};
  double period = 0.33;  ///< control cycle [s]
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, Platform>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"name", "", "name of the platform"}, o.name);
  visit(Field{"body", "", "size and limits of the body"}, o.body);
  visit(Field{"sonar", "", "places of the sonars"}, o.sonar);
  visit(Field{"bumper", "", "places of the bumpers"}, o.bumper);
  visit(Field{"whisker", "", "places of the whiskers' roots"}, o.whisker);
  visit(Field{"light", "", "places of the light sensors"}, o.light);
  visit(Field{"period", "s", "control cycle", 0.001, 10}, o.period);
}

/// Platform by name; throws ArgumentError that lists the known ones.
const Platform& platform(const std::string& name);
std::vector<std::string> platform_names();

}  // namespace meander

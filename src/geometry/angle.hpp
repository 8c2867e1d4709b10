// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cmath>
#include <numbers>

namespace meander {

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine to within 1e-15 for |angle| <= 1e5, with the same bits on every machine and under every C library:
/// states that are hashed use these, because the library's differ between versions and processors.
SinCos sin_cos(double angle);

/// Angle of (x, y) in (-pi, pi] to within 1e-15; 0 for (0, 0). Same bits everywhere.
double angle_of(double y, double x);

/// The angle in (-pi, pi].
double wrap_angle(double angle);

/// The way from angle `from` to angle `to`, in (-pi, pi].
inline double angle_between(double from, double to) { return wrap_angle(to - from); }

}  // namespace meander

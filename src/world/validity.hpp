// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "world/edit.hpp"

namespace meander {

/// What a thing must be whatever stands around it. Refused with ArgumentError:
///   - shapes that invalid() refuses; numbers that are not finite; anything farther than kFarthest
///   (geometry/shapes.hpp) along x or y;
///   - names that are not 1 to 64 characters of UTF-8 without control characters;
///   - echo outside [0, 1], a specular limit outside [0, pi/2], radius, tolerance or light strength <= 0, speed < 0.
/// Allowed: a mover without waypoints (it stands still), a light anywhere.
void check_item(const Item& item);

/// Bounds of positive size, finite numbers, a title of one line, a note of plain text.
void check_header(const Header& header);

/// The one form a thing is stored in, so that equal things are equal bit by bit: rings in canonical order, headings in
/// (-pi, pi], no negative zero. Takes any value, also an invalid one.
Item normalised(Item item);
Header normalised(Header header);

inline constexpr double kLargestHeading = 1e6;   ///< [rad]; before it is brought into (-pi, pi]
inline constexpr double kLargestNumber = 1e6;    ///< of speeds and strengths
inline constexpr std::size_t kLongestName = 64;  ///< in characters
inline constexpr std::size_t kLongestNote = 10000;

/// "obstacle 'crate'".
std::string label(const Item& item);
/// "(1.5, 2)", to 4 digits: for messages.
std::string point_text(const Vec2& p);

}  // namespace meander

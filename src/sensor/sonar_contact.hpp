// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "sensor/sonar_candidates.hpp"

namespace meander::sonar {

/// Tells whether a transducer touches or is inside something: its body's centre is inside a solid, or the leg from the
/// centre to the transducer meets a wall or disc.
class Contact {
 public:
  bool operator()(const ShapeIndex& index, const Candidates& list, const Vec2& center, const Vec2& transducer);

  /// To be called when the list was gathered anew.
  void forget() { free_radius_ = -1; }

 private:
  void look_around(const ShapeIndex& index, const Candidates& list, const Vec2& center);

  // Around the place of the last full look nothing stands within the free radius: there, the answer is known.
  Vec2 place_{0, 0};
  double free_radius_ = -1;
  bool inside_ = false;
};

}  // namespace meander::sonar

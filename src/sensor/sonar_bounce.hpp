// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "sensor/sonar_cone.hpp"

namespace meander::sonar {

/// Sound that met no answer travels on: what stands before a mirroring wall is seen a second time, from the mirror
/// image of the listening place, through the part of the wall that the transducer sees.
class Bounce {
 public:
  /// Distance of the first echo over one wall that is nearer than the direct one (the result of `direct`), or that.
  double first_echo(const Candidates& list, const Cone& direct, double shift, double most);

 private:
  double through(const Candidates& list, const WedgeView& seen, const Piece& wall, double low, double high,
                 double shift, double most);

  Shadows shadows_;
  Cone mirrored_;
};

/// The view as a mirror along the line through a and b shows it.
View mirrored(const View& view, const Vec2& a, const Vec2& b);

}  // namespace meander::sonar

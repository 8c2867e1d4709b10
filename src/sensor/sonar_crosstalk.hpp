// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "sensor/sonar_candidates.hpp"

namespace meander::sonar {

/// One of the transducers that fire together.
struct Ear {
  View view;
  double range;    ///< what it reads [m]
  double nearest;  ///< nothing in its cone is nearer [m]
};

/// How transducers send and hear.
struct Lobes {
  Wedge sent;      ///< the cone of the sound, symmetrical
  SinCos receive;  ///< of the half angle in which a foreign sound is heard
  double range;    ///< half the longest way that is heard over a wall of strength 1 [m]
};

/// Transducers that fire together hear each other: the sound of one reaches another over a wall that mirrors it into
/// the other's receive lobe, and is taken for an echo at half the way. One reflection, walls only.
class Crosstalk {
 public:
  /// Shortens the ranges of those that hear another before their own echo.
  void hear_each_other(const Candidates& list, std::span<const Reflector> reflectors, const Lobes& lobes,
                       std::span<Ear> ears);

 private:
  struct Hearer {
    Ear* ear;
    double most;  ///< the wall is at most this far from the sender [m]
  };
  double find_hearers(const SinCos& open, std::span<Ear> ears, const Ear& sender);
  std::vector<Hearer> hearers_;  ///< of one sender
};

}  // namespace meander::sonar

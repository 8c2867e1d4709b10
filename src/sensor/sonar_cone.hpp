// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "sensor/sonar_candidates.hpp"
#include "sensor/sonar_occlusion.hpp"

namespace meander::sonar {

/// What one wedge holds, found exactly and without rays: of the parts of walls and discs within the wedge, and of the
/// corners, the nearest that answers and is not hidden.
class Cone {
 public:
  /// Distance of the first echo, or `most`. `shift` >= distance of the listening place from the centre of the list.
  double first_echo(const Candidates& list, const View& view, const Wedge& wedge, const Hearing& hearing,
                    std::span<const Reflector> reflectors, double shift, double most);

  /// After first_echo: everything in the wedge that is nearer than the echo (and more).
  const WedgeView& in_wedge() const { return in_wedge_; }
  /// After first_echo: nothing in the wedge is nearer than this [m].
  double nearest() const;

 private:
  void look_at(const Candidates& list, const Cull& cull, const Outward& walk);
  void look_at_moving(const Candidates& list, const Cull& cull);
  void cover();
  double lowest_echo();
  void settle_within(double reach);

  WedgeView in_wedge_;
  Shadows shadows_;
  double bound_ = 0;         ///< the first echo is not farther
  double best_ = 0;          ///< the first echo settled so far, or `most`
  double next_ = 0;          ///< least range of the echoes not yet settled
  bool all_answer_ = false;  ///< at any incidence
  std::size_t covered_ = 0;  ///< pieces looked at by cover()
  std::size_t heard_ = 0;    ///< echoes counted in next_
  double cover_low_ = 0, cover_high_ = 0, cover_far_squared_ = 0;
};

}  // namespace meander::sonar

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <chrono>
#include <functional>

#include "base/work.hpp"

namespace meander::script {

/// Leads simulated time along the wall clock, and says when a frame is due. The wall clock decides about waiting and
/// drawing alone.
class Pace {
 public:
  /// `speed`: simulated seconds per second, 0 or infinite: as fast as it goes. `rate`: frames per second.
  Pace(double speed, double rate, Work work);

  /// Waits until simulated time may be `to`, having been `from`. For each frame due meanwhile it calls draw(share),
  /// with the share of the way in [0, 1]. Throws Cancelled when a stop was asked for.
  void pass(double from, double to, const std::function<void(double share)>& draw);
  /// Waits until the next frame is due.
  void wait_for_frame();
  /// Simulated seconds per second so far.
  double measured() const;

 private:
  using Clock = std::chrono::steady_clock;

  void wait_until(Clock::time_point time) const;

  double speed_;
  Clock::duration interval_;
  Work work_;
  Clock::time_point begun_, next_frame_, due_;
  double passed_ = 0;  ///< simulated time [s]
};

}  // namespace meander::script

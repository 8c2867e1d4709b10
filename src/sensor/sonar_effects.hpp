// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "base/random.hpp"
#include "sensor/sonar.hpp"

namespace meander::sonar {

/// The random part of the model. Each effect draws from a stream of its own and a fixed number of times a reading, so
/// that switching one on or off never shifts another.
class Effects {
 public:
  Effects(const SonarOptions& options, int count, std::uint64_t seed);

  /// By how much the incidence limit of this transducer is off in this reading [rad]. Held over readings.
  double limit_shift(int transducer);
  /// What is read where the true echo is at `range`.
  double reading(int transducer, double range);
  /// A reading that nothing disturbs, with the same draws.
  double undisturbed(int transducer, double range);

  void add_to(Hash& hash) const;

 private:
  double disturbed(double range, double last);

  SonarOptions options_;
  Stream flicker_, noise_, outliers_;
  std::vector<double> shift_;  ///< of the incidence limit, in standard deviations
  std::vector<double> last_;   ///< last reading; NaN before the first
};

}  // namespace meander::sonar

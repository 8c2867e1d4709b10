// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "base/hash.hpp"
#include "robot/platform.hpp"
#include "sensor/scene.hpp"

namespace meander {

enum class Firing { simultaneous, sequence };
template <>
struct EnumNames<Firing> {
  static constexpr std::pair<Firing, const char*> entries[] = {{Firing::simultaneous, "simultaneous"},
                                                               {Firing::sequence, "sequence"}};
};

/// Every effect of the sonar model, each with its own switch (a zero or `false` turns it off). Sources: docs/sonar.md.
struct SonarOptions {
  double half_cone = 0.2181661564992912;
  double range_min = 0.152;
  double range_max = 6.477;
  bool incidence = true;
  double incidence_limit = 0.5235987755982988;
  double incidence_jitter = 0;
  double jitter_hold = 10;
  double near_field = 0.30;
  double corner_range = 1.75;
  bool bounce = false;
  double noise = 0.01;
  double noise_proportional = 0.01;
  double dropout = 0;
  double spurious = 0;
  double repeat = 0;
  Firing firing = Firing::sequence;
  int fired_together = 1;
  bool crosstalk = false;
  double receive_lobe = 0.6108652381980153;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"half_cone", "rad", "half opening angle of the cone", 0.001, 1.5}, o.half_cone);
  visit(Field{"range_min", "m", "least range; a transducer in contact reads this", 0, 100}, o.range_min);
  visit(Field{"range_max", "m", "range read when nothing echoes", 0.01, 1000}, o.range_max);
  visit(Field{"incidence", "", "walls echo only near the normal"}, o.incidence);
  visit(Field{"incidence_limit", "rad", "largest angle to the normal that echoes", 0, 1.5707963267948966},
        o.incidence_limit);
  visit(Field{"incidence_jitter", "rad", "standard deviation of that limit per reading", 0, 1.5}, o.incidence_jitter);
  visit(Field{"jitter_hold", "", "readings for which one jitter value holds, on average", 1, 1e6}, o.jitter_hold);
  visit(Field{"near_field", "m", "nearer than this everything echoes; 0: off", 0, 100}, o.near_field);
  visit(Field{"corner_range", "m", "convex corners answer up to here; 0: off", 0, 1000}, o.corner_range);
  visit(Field{"bounce", "", "beams without an echo travel on after one mirror reflection"}, o.bounce);
  visit(Field{"noise", "m", "standard deviation, constant part", 0, 10}, o.noise);
  visit(Field{"noise_proportional", "", "standard deviation, share of the range", 0, 1}, o.noise_proportional);
  visit(Field{"dropout", "", "probability of reading the maximum", 0, 1}, o.dropout);
  visit(Field{"spurious", "", "probability of a short false echo", 0, 1}, o.spurious);
  visit(Field{"repeat", "", "probability of repeating the last reading exactly", 0, 1}, o.repeat);
  visit(Field{"firing", "", "all at once or one group after the other while the robot moves"}, o.firing);
  visit(Field{"fired_together", "", "transducers per group of the firing sequence", 1, 1024}, o.fired_together);
  visit(Field{"crosstalk", "", "transducers fired together hear each other"}, o.crosstalk);
  visit(Field{"receive_lobe", "rad", "half angle in which a foreign echo is heard", 0, 1.5}, o.receive_lobe);
}

/// "ideal", "nomad" (default) or "real"; throws ArgumentError that lists the known ones.
SonarOptions sonar_preset(const std::string& name);
std::vector<std::string> sonar_preset_names();

/// A ring of sonars with its state (random stream, held jitter, last readings, candidate list). Copying it forks it.
class SonarRing {
 public:
  SonarRing(const RingLayout& layout, const SonarOptions& options, std::uint64_t seed);
  SonarRing(const SonarRing&);
  SonarRing& operator=(const SonarRing&);
  SonarRing(SonarRing&&) noexcept;
  SonarRing& operator=(SonarRing&&) noexcept;
  ~SonarRing();

  const SonarOptions& options() const;
  const RingLayout& layout() const;

  /// When each transducer fires, as a fraction (0, 1] of the scan's duration. All 1 for simultaneous firing.
  std::span<const double> firing_times() const;

  /// One scan: `poses_world[i]` is the robot's true pose when transducer i fires; `ranges` receives one range [m] each.
  /// `self` is the owner number of the scanning robot's own disc in scene.moving (ignored), or kNobody. Allocates
  /// nothing in the steady state.
  void scan(const Scene& scene, std::span<const Pose2> poses_world, std::uint32_t self, std::span<double> ranges);

  static constexpr std::uint32_t kNobody = ~0u;

  void add_to(Hash& hash) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace meander

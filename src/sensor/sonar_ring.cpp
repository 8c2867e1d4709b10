// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>

#include "base/error.hpp"
#include "sensor/sonar.hpp"
#include "sensor/sonar_bounce.hpp"
#include "sensor/sonar_candidates.hpp"
#include "sensor/sonar_cone.hpp"
#include "sensor/sonar_contact.hpp"
#include "sensor/sonar_crosstalk.hpp"
#include "sensor/sonar_effects.hpp"

namespace meander {

using namespace sonar;

struct SonarRing::State {
  State(const RingLayout& l, const SonarOptions& o, std::uint64_t seed);

  Vec2 center_ahead(const Vec2& place) const;
  void follow(const Scene& scene, std::span<const Pose2> poses, std::uint32_t self);
  void take_places(const Scene& scene, std::span<const Pose2> poses);
  void set_reflectors(double limit_shift);
  double listen(int transducer);
  void listen_together();

  RingLayout layout;
  SonarOptions options;
  int groups;  ///< transducer i fires in group i % groups
  std::vector<double> times;
  std::vector<Vec2> bearings;
  Wedge wedge;
  Hearing hearing;
  Effects effects;

  Candidates list;
  double roam = -1;                   ///< the list serves places up to here from its centre [m]
  std::shared_ptr<const char> index;  ///< that the list was gathered from, at this revision
  std::uint64_t revision = 0;
  Contact contact;

  std::vector<View> views;             ///< of this scan, per transducer
  std::vector<std::uint8_t> touching;  ///< per transducer
  std::vector<double> echoes;          ///< undisturbed ranges, per transducer
  std::vector<double> nearest;         ///< of anything in the cone, per transducer
  std::vector<Reflector> reflectors;   ///< per material of the list, for the incidence limit shifted by ...
  double reflectors_shift = 0;
  Cone cone;
  Bounce bounce;
  Crosstalk crosstalk;
  std::vector<Ear> ears;  ///< of one group
};

namespace {

/// A candidate list serves until the robot is this far from where it was gathered [m].
constexpr double kRoam = 0.5;

int group_count(const SonarOptions& options, int count) {
  if (options.firing == Firing::simultaneous || count == 0) return 1;
  return (count + options.fired_together - 1) / options.fired_together;
}

Wedge wedge_of(double half) {
  const SinCos t = sin_cos(half);
  return {.low = -t.sin / t.cos, .high = t.sin / t.cos};
}

Hearing hearing_of(const SonarOptions& o) {
  return {.incidence = o.incidence, .near_field = o.near_field, .corner_range = o.corner_range, .range = o.range_max};
}

Reflector reflector_of(const Material& material, double default_limit, double shift) {
  const double limit = (std::isnan(material.specular_limit) ? default_limit : material.specular_limit) + shift;
  const SinCos t = sin_cos(std::clamp(limit, 0.0, kPi / 2));
  return {.strength = material.echo, .tan_limit = t.sin / t.cos, .sin_limit = t.sin};
}

}  // namespace

SonarRing::State::State(const RingLayout& l, const SonarOptions& o, std::uint64_t seed)
    : layout(l),
      options(o),
      groups(group_count(o, l.count)),
      wedge(wedge_of(o.half_cone)),
      hearing(hearing_of(o)),
      effects(o, l.count, seed) {
  for (int i = 0; i < layout.count; ++i) {
    times.push_back(static_cast<double>(i % groups + 1) / groups);
    const SinCos t = sin_cos(layout.first + 2 * kPi * i / layout.count);
    bearings.push_back({t.cos, t.sin});
  }
  views.resize(layout.count);
  touching.resize(layout.count);
  echoes.resize(layout.count);
  nearest.resize(layout.count);
}

/// Where to gather: ahead on the way out of the old list, so that the new one serves on a longer way.
Vec2 SonarRing::State::center_ahead(const Vec2& place) const {
  const Vec2 way = place - list.center();
  const double length = way.norm();
  return length > 0 && length < 2 * kRoam ? Vec2(place + way * (0.8 * kRoam / length)) : place;
}

/// Keeps the candidate list as long as it serves.
void SonarRing::State::follow(const Scene& scene, std::span<const Pose2> poses, std::uint32_t self) {
  const ShapeIndex& walls = scene.walls();
  double away = 0, spread = 0;
  for (const Pose2& pose : poses) {
    away = std::max(away, (pose.position() - list.center()).norm());
    spread = std::max(spread, (pose.position() - poses.front().position()).norm());
  }
  if (index != walls.identity() || !(away <= roam) ||
      (revision != walls.revision() && walls.touched_since(revision, list.center(), list.radius()))) {
    roam = kRoam + spread;
    list.gather(walls, center_ahead(poses.front().position()), options.range_max + layout.radius + roam);
    contact.forget();
    reflectors.clear();
  }
  index = walls.identity();
  revision = walls.revision();
  list.set_moving(scene.moving, self);
}

void SonarRing::State::take_places(const Scene& scene, std::span<const Pose2> poses) {
  SinCos turn{0, 1};
  for (int i = 0; i < layout.count; ++i) {
    const Pose2& pose = poses[i];
    if (i == 0 || pose.heading != poses[i - 1].heading) turn = sin_cos(pose.heading);
    const Vec2 ahead(turn.cos * bearings[i].x() - turn.sin * bearings[i].y(),
                     turn.sin * bearings[i].x() + turn.cos * bearings[i].y());
    views[i] = {pose.position() + layout.radius * ahead, ahead, left_of(ahead)};
    touching[i] = contact(scene.walls(), list, pose.position(), views[i].origin);
  }
}

void SonarRing::State::set_reflectors(double limit_shift) {
  if (!reflectors.empty() && limit_shift == reflectors_shift) return;
  reflectors_shift = limit_shift;
  reflectors.clear();
  for (const Material& material : list.materials())
    reflectors.push_back(reflector_of(material, options.incidence_limit, limit_shift));
}

/// The undisturbed range of one transducer.
double SonarRing::State::listen(int i) {
  set_reflectors(effects.limit_shift(i));
  if (touching[i]) return options.range_min;
  const double shift = (views[i].origin - list.center()).norm();
  const double direct = cone.first_echo(list, views[i], wedge, hearing, reflectors, shift, options.range_max);
  nearest[i] = cone.nearest();
  return options.bounce ? bounce.first_echo(list, cone, shift, direct) : direct;
}

/// Crosstalk within every group of the firing sequence.
void SonarRing::State::listen_together() {
  const Lobes lobes{.sent = wedge, .receive = sin_cos(options.receive_lobe), .range = options.range_max};
  for (int group = 0; group < groups; ++group) {
    ears.clear();
    for (int i = group; i < layout.count; i += groups)
      if (!touching[i]) ears.push_back({views[i], echoes[i], nearest[i]});
    crosstalk.hear_each_other(list, reflectors, lobes, ears);
    std::size_t ear = 0;
    for (int i = group; i < layout.count; i += groups)
      if (!touching[i]) echoes[i] = ears[ear++].range;
  }
}

SonarRing::SonarRing(const RingLayout& layout, const SonarOptions& options, std::uint64_t seed) {
  validate(layout);
  validate(options);
  if (options.range_min >= options.range_max)
    fail("option 'range_min': a number below range_max = {} expected, got {}", options.range_max, options.range_min);
  state_ = std::make_unique<State>(layout, options, seed);
}
SonarRing::SonarRing(const SonarRing& other) : state_(std::make_unique<State>(*other.state_)) {}
SonarRing& SonarRing::operator=(const SonarRing& other) { return *this = SonarRing(other); }
SonarRing::SonarRing(SonarRing&&) noexcept = default;
SonarRing& SonarRing::operator=(SonarRing&&) noexcept = default;
SonarRing::~SonarRing() = default;

const SonarOptions& SonarRing::options() const { return state_->options; }
const RingLayout& SonarRing::layout() const { return state_->layout; }
std::span<const double> SonarRing::firing_times() const { return state_->times; }
void SonarRing::add_to(Hash& hash) const { state_->effects.add_to(hash); }

void SonarRing::scan(const Scene& scene, std::span<const Pose2> poses_world, std::uint32_t self,
                     std::span<double> ranges) {
  State& s = *state_;
  const auto count = static_cast<std::size_t>(s.layout.count);
  if (poses_world.size() != count || ranges.size() != count)
    fail("sonar scan: {} poses and ranges expected, got {} and {}", count, poses_world.size(), ranges.size());
  if (count == 0) return;
  s.follow(scene, poses_world, self);
  s.take_places(scene, poses_world);
  for (std::size_t i = 0; i < count; ++i) s.echoes[i] = s.listen(static_cast<int>(i));
  if (s.options.crosstalk) s.listen_together();
  for (std::size_t i = 0; i < count; ++i)
    ranges[i] = s.touching[i] ? s.effects.undisturbed(static_cast<int>(i), s.echoes[i])
                              : s.effects.reading(static_cast<int>(i), s.echoes[i]);
}

}  // namespace meander

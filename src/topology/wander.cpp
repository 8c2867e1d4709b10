// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/wander.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace meander::topology {
namespace {

enum class Behaviour { bounce, wall, sparse, doubted };

/// Directions tried when it looks for few cells.
constexpr int kDirections = 12;
/// Samples between two looks.
constexpr int kLookEvery = 10;

class Wander {
 public:
  Wander(std::shared_ptr<TopologicMap> map, const WanderOptions& options)
      : map_(std::move(map)),
        options_(options),
        stream_(options.seed, "wander"),
        contacts_(map_->whiskers()),
        revisit_(map_, options.revisit) {
    validate(options);
    if (options.longest < options.shortest)
      fail("option 'longest': at least 'shortest' ({}) expected, got {}", options.shortest, options.longest);
    way_ = stream_.uniform(-kPi, kPi);
  }

  GuideStep next(const Observation& seen) {
    map_->step(seen);
    contacts_.update(seen, went_);
    if (samples_++ >= options_.samples)
      return {std::nullopt, true, fmt::format("{} samples gathered", options_.samples), 0};
    if (--left_ <= 0 && behaviour_ != Behaviour::doubted) change_behaviour();
    if (behaviour_ == Behaviour::doubted)
      if (const auto place = doubted_place()) return to_doubted(*place, seen.odometry.pose);
    const double own = seen.odometry.pose.heading;  // ways are kept in the odometry frame, contacts in the robot's
    went_ = choose(wrap_angle(way_ - own));
    way_ = own + *went_;
    const SinCos t = sin_cos(wrap_angle(way_));
    const Vec2 target = seen.odometry.pose.position() + options_.lookahead * Vec2(t.cos, t.sin);
    return {Subgoal{target, 0.05, {}, {}}, false, {}, 0};
  }

 private:
  void change_behaviour() {
    const double share = options_.revisit.share;
    if (share > 0 && stream_.chance(share) && revisit_.begin()) {
      behaviour_ = Behaviour::doubted;
      left_ = options_.longest;
    } else {
      change_to_any();
    }
  }

  void change_to_any() {
    behaviour_ = static_cast<Behaviour>(stream_.below(3));
    left_ = options_.shortest + stream_.below(options_.longest - options_.shortest + 1);
    side_ = stream_.chance(0.5) ? 1 : -1;
  }

  /// In the frame of the map: one doubted link after the other. Where none is left, or time is up after one, another
  /// behaviour.
  std::optional<Vec2> doubted_place() {
    auto place = revisit_.next(contacts_);
    while (!place && left_ > 0 && revisit_.begin()) place = revisit_.next(contacts_);
    if (!place) change_to_any();
    return place;
  }

  GuideStep to_doubted(const Vec2& place, const Pose2& odometry) {
    const Vec2 target = inverse(map_->map_from_odometry()) * place;
    const Vec2 way = target - odometry.position();
    way_ = angle_of(way.y(), way.x());
    went_.reset();  // the navigator knows what holds it
    return {Subgoal{target, 0.02, {}, {}}, false, {}, 0};
  }

  /// Bearings in the robot's frame from here on.
  double choose(double way) {
    switch (behaviour_) {
      case Behaviour::bounce:
        return bounce(way);
      case Behaviour::wall:
        return follow_wall(way);
      case Behaviour::sparse:
        return left_ % kLookEvery == 0 ? to_few_cells(way) : bounce(way);
      case Behaviour::doubted:
        return way;
    }
    return way;
  }

  double bounce(double way) {
    if (contacts_.free(way, options_.half_width)) return way;
    double other = 0;
    return contacts_.nearest_free(stream_.uniform(-kPi, kPi), options_.half_width, kPi, other) ? other : way;
  }

  /// With the wall at its side; a lost wall is looked for by turning to that side.
  double follow_wall(double way) {
    const double wanted = contacts_.any() ? contacts_.middle() - side_ * (kPi / 2 - options_.wall_turn)
                                          : way + side_ * (seen_wall_ ? options_.wall_turn : 0);
    seen_wall_ = contacts_.any() || seen_wall_;
    double free = 0;
    return contacts_.nearest_free(wanted, options_.half_width, kPi, free) ? free : wrap_angle(wanted);
  }

  double to_few_cells(double way) {
    const Pose2& pose = map_->pose();
    int fewest = -1;
    double best = way;
    const int first = stream_.below(kDirections);
    for (int i = 0; i < kDirections; ++i) {
      const double bearing = wrap_angle((first + i) * (2 * kPi / kDirections));
      if (!contacts_.free(bearing, options_.half_width)) continue;
      const SinCos t = sin_cos(wrap_angle(pose.heading + bearing));
      const Vec2 there = pose.position() + options_.lookahead * Vec2(t.cos, t.sin);
      int crowd = 0;
      map_->net().around(there, options_.crowd, [&](int cell) {
        crowd += (map_->net().cells()[cell].position - there).norm() <= options_.crowd;
      });
      if (fewest >= 0 && crowd >= fewest) continue;
      fewest = crowd;
      best = bearing;
    }
    return best;
  }

  std::shared_ptr<TopologicMap> map_;
  WanderOptions options_;
  Stream stream_;
  WhiskerContacts contacts_;
  Revisit revisit_;
  Behaviour behaviour_ = Behaviour::bounce;
  int samples_ = 0, left_ = 0, side_ = 1;
  bool seen_wall_ = false;
  std::optional<double> went_;  ///< the last way, in the robot's frame
  double way_ = 0;              ///< [rad] in the odometry frame
};

}  // namespace

Guide wander(const std::shared_ptr<TopologicMap>& map, const WanderOptions& options) {
  const auto explorer = std::make_shared<std::unique_ptr<Wander>>(std::make_unique<Wander>(map, options));
  return {"wander", [explorer](const Observation& seen, const NavigatorStep&) { return (*explorer)->next(seen); },
          [explorer, map, options] { *explorer = std::make_unique<Wander>(map, options); }, 0};
}

}  // namespace meander::topology

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/route_guide.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/angle.hpp"

namespace meander::topology {
namespace {

constexpr int kTrail = 40;                          ///< situations, ...
constexpr double kSpacing = 0.05;                   ///< ... one every so many metres
constexpr double kSpread = 0.35;                    ///< cells so near to a supposed place may be meant [m]
constexpr std::size_t kAhead = 4;                   ///< links of the way that are watched for suspension
constexpr double kGoldenAngle = 2.399963229728653;  ///< [rad]; its multiples lie nowhere near each other
constexpr int kStray = 40;                          ///< samples
constexpr double kStrayWay = 2;                     ///< [m]; it slides along what is in the way
constexpr double kSpiral = 0.11;                    ///< [m] from the goal to the first point, times sqrt(k) to the k-th
constexpr double kSeen = 0.08;                      ///< so near to such a point it goes on to the next [m]
constexpr int kLook = 15;                           ///< samples after which it does so anyhow
constexpr int kPulls = 20;                          ///< to where the senses tell
constexpr double kLikeGrowth = 0.03;                ///< per point
constexpr double kConfirmGrowth = 0.1;              ///< [m] per recovery

class RouteGuide {
 public:
  RouteGuide(std::shared_ptr<TopologicMap> map, int goal, const RouteGuideOptions& options)
      : RouteGuide(std::move(map), goal, 0, options) {
    validate(options);
    if (!cells().alive(goal)) fail("route: cell {} is not in the map", goal);
    serial_ = cells()[goal].serial;
  }

  /// A new run to the same cell, which may be gone by then.
  void reset() { *this = RouteGuide(map_, goal_, serial_, options_); }

  GuideStep next(const Observation& seen) {
    options_.learn ? map_->step(seen) : map_->follow(seen);
    if (!cells().alive(goal_) || cells()[goal_].serial != serial_) return ended(false, "the goal's cell is gone");
    if (++samples_ > options_.most_samples) return ended(false, "too many samples");
    trail_.add(map_->situation());
    if (samples_ < stray_until_) return to(stray_);
    if (!on_way() && !plan() && !recover()) return ended(false, "no links lead there");
    pass_places();
    const bool held = stuck(seen.odometry.pose.position());
    if (next_ + 1 == way_.size() && (looks_ > 0 || held || distance_to(goal_) <= options_.arrive)) {
      if (agrees()) return ended(true, "arrived, and the senses agree");
      if (!look_about() && !recover()) return ended(false, "at the believed place the senses tell another");
    } else if (held && !get_free(seen.odometry.pose)) {
      return ended(false, "stuck, and no other links lead there");
    }
    return to(inverse(map_->map_from_odometry()) * target());
  }

 private:
  RouteGuide(std::shared_ptr<TopologicMap> map, int goal, std::uint64_t serial, const RouteGuideOptions& options)
      : map_(std::move(map)),
        goal_(goal),
        options_(options),
        serial_(serial),
        trail_(kTrail, kSpacing, map_->net().metric().stride()) {}

  const CellPool& cells() const { return map_->net().cells(); }
  Vec2 here() const { return map_->pose().position(); }
  double distance_to(int cell) const { return (cells()[cell].position - here()).norm(); }
  static GuideStep to(const Vec2& place) { return {Subgoal{place, 0.02, {}, {}}, false, {}, 0}; }
  static GuideStep ended(bool success, const char* why) { return {std::nullopt, success, why, success ? 1 : 0}; }

  /// Is there a way whose cells and next links still hold?
  bool on_way() const {
    if (way_.empty()) return false;
    for (std::size_t i = next_; i < way_.size(); ++i) {
      if (!cells().alive(way_[i])) return false;
      if (i == 0 || i > next_ + kAhead) continue;
      const Link* link = cells().alive(way_[i - 1]) ? cells().find(way_[i - 1], way_[i]) : nullptr;
      if (!link || (link->suspended && !suspended_accepted_)) return false;
    }
    return true;
  }

  bool plan() {
    const int start = nearest_place(cells(), here());
    const auto found = route(cells(), start, goal_, options_.route, given_up_);
    if (!found) return false;
    way_ = *found;
    next_ = way_.size() > 1 && distance_to(way_[0]) < options_.near ? 1 : 0;
    suspended_accepted_ = false;
    for (std::size_t i = 1; i < way_.size(); ++i)
      suspended_accepted_ = suspended_accepted_ || cells().find(way_[i - 1], way_[i])->suspended;
    return true;
  }

  void pass_places() {
    while (next_ + 1 < way_.size() && distance_to(way_[next_]) < options_.near) ++next_;
  }

  /// Did the wheels bring it nowhere for long?
  bool stuck(const Vec2& odometry) {
    if ((odometry - anchor_).norm() > options_.progress) {
      anchor_ = odometry;
      since_ = samples_;
    }
    return samples_ - since_ > options_.patience;
  }

  /// Lost: the robot is where its last stretch of way fits the map clearly better than where it believes to be, if
  /// there is such a place. What it believed blocked meanwhile may not have been where it thought.
  bool recover() {
    if (recovered_++ >= options_.recoveries) return false;
    for (const auto& [a, b] : given_up_)
      if (map_->options().doubt.suspend > 0 && cells().alive(a) && cells().alive(b) && cells().find(a, b)) {
        Link link = *cells().find(a, b);
        link.suspended = false;
        link.doubt = 0;
        map_->net().cells().connect(a, b, link);
      }
    given_up_.clear();
    if (const auto place = trail_.find(map_->net(), kSpread)) {
      map_->shift(place->position - here());
      trail_.clear();
    }
    looks_ = pulls_ = 0;
    return plan();
  }

  /// Stuck: the link on which nothing moves is suspended, the robot strays off for a little and tries another way.
  bool get_free(const Pose2& odometry) {
    const Vec2 way = inverse(map_->map_from_odometry()) * target() - odometry.position();
    const SinCos off = sin_cos(wrap_angle(angle_of(way.y(), way.x()) + ++stuck_ * kGoldenAngle));
    stray_ = odometry.position() + kStrayWay * Vec2(off.cos, off.sin);
    stray_until_ = since_ = samples_ + kStray;
    if (stuck_ % 3 == 0) return recover();
    if (next_ == 0) return true;
    give_up(way_[next_ - 1], way_[next_]);
    return plan() || recover();
  }

  /// A link of the way; where it was passed while learning it may be gone. A map whose links are never suspended stays
  /// as it is.
  void give_up(int from, int to) {
    if (!cells().alive(from) || !cells().find(from, to)) return;
    Link link = *cells().find(from, to);
    if (!link.suspended) given_up_.emplace_back(from, to);
    if (map_->options().doubt.suspend == 0) return;
    link.suspended = true;
    link.doubt = std::max(link.doubt, map_->options().doubt.suspend);
    map_->net().cells().connect(from, to, link);
  }

  /// How near to the goal a place is beside it [m]: the map may lie in layers there, so that the senses never tell the
  /// goal itself. The more often it has looked everywhere, the farther off counts.
  double beside() const { return options_.confirm + kConfirmGrowth * recovered_; }

  /// Do the senses tell the goal, or a place beside it or none while they are like the goal's? The longer it has
  /// looked, the less alike is enough.
  bool agrees() const {
    const int told = map_->correction().cell;
    if (told == goal_) return true;
    if (told >= 0 && (cells()[told].position - cells()[goal_].position).norm() > beside()) return false;
    const double like = options_.like + kLikeGrowth * looks_;
    return map_->net().metric().squared(cells().senses(goal_), map_->situation().senses) <= like * like;
  }

  /// Not at the goal: the robot is where the senses tell when that is elsewhere, else somewhere around the goal, and
  /// looks there in growing circles. False when it has looked everywhere.
  bool look_about() {
    const int told = map_->correction().cell;
    if (told >= 0 && (cells()[told].position - cells()[goal_].position).norm() > beside()) {
      if (++pulls_ > kPulls) return false;
      map_->shift(options_.pull * (cells()[told].position - here()));
      if (!plan()) return false;
    }
    if (looks_ == 0 || (target() - here()).norm() < kSeen || samples_ > look_until_) {
      ++looks_;
      look_until_ = samples_ + kLook;
    }
    since_ = samples_;
    return looks_ <= options_.tries;
  }

  /// Where to drive now, in the map: the next place, or when looking about a point on a spiral around it.
  Vec2 target() const {
    const Vec2 place = cells()[way_[next_]].position;
    if (next_ + 1 < way_.size() || looks_ == 0) return place;
    const SinCos t = sin_cos(wrap_angle(looks_ * kGoldenAngle));
    return place + kSpiral * std::sqrt(looks_) * Vec2(t.cos, t.sin);
  }

  std::shared_ptr<TopologicMap> map_;
  int goal_;
  RouteGuideOptions options_;
  std::uint64_t serial_;
  std::vector<int> way_;
  std::size_t next_ = 0;
  bool suspended_accepted_ = false;  ///< there is no way without a suspended link
  Trail trail_;
  CellPairs given_up_;  ///< links on which it got stuck
  int recovered_ = 0, stuck_ = 0;
  int looks_ = 0, look_until_ = 0;  ///< points around the goal, and the sample until which it goes to the last one
  int pulls_ = 0;
  Vec2 stray_{0, 0};       ///< in the odometry frame
  int stray_until_ = 0;    ///< sample
  Vec2 anchor_{1e9, 1e9};  ///< in the odometry frame
  int since_ = 0, samples_ = 0;
};

}  // namespace

Guide route_guide(const std::shared_ptr<TopologicMap>& map, int goal, const RouteGuideOptions& options) {
  const auto guide = std::make_shared<RouteGuide>(map, goal, options);
  return {"route", [guide](const Observation& seen, const NavigatorStep&) { return guide->next(seen); },
          [guide] { guide->reset(); }, 1};
}

}  // namespace meander::topology

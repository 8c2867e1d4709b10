// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <set>

#include "round_room.hpp"
#include "topology/map_text.hpp"
#include "topology/revisit.hpp"
#include "topology/wander.hpp"
#include "topology/whisker_drive.hpp"

namespace meander {
std::size_t allocations();  // allocation_counter.cpp
}

namespace meander::topology {
namespace {

constexpr double kRoom = 1.5;   ///< half of its side [m]
constexpr double kGate = 0.4;   ///< the wall that comes and goes: round x = 0, from the lower side to this y
constexpr double kThick = 0.1;  ///< half of it [m]

/// A robot that goes where it is sent in a square room with one lamp, until walls hold it. Its odometry is right.
class SquareRoom {
 public:
  SquareRoom() : drive_(whisker_drive(platform("alice"), {.patience = 1e6})) {
    seen_.readings.whisker.resize(24);
    seen_.readings.light.resize(24);
    seen_.period = 0.2;
    seen_.odometry.pose = {-0.7, -0.7, 0};
    sense();
  }
  const Observation& seen() const { return seen_; }
  void close(bool closed) { closed_ = closed; }
  void go(const Vec2& target) {
    const NavigatorStep step = drive_.step(seen_, {target, 0.02, {}, {}});
    Pose2& pose = seen_.odometry.pose;
    const Vec2 before = pose.position();
    for (const Vec2& by : {Vec2(0.2 * step.command.v, 0), Vec2(0, 0.2 * step.command.vy)}) {
      const Vec2 there = pose.position() + by;
      if (!fits(there)) continue;
      pose.x = there.x();
      pose.y = there.y();
    }
    seen_.odometry.v = (pose.x - before.x()) / 0.2;
    seen_.odometry.vy = (pose.y - before.y()) / 0.2;
    seen_.time += 0.2;
    sense();
  }
  void follow(Guide& guide, int samples) {
    for (int i = 0; i < samples; ++i)
      if (const auto step = guide.next(seen_, {}); step.subgoal) go(step.subgoal->position);
  }

 private:
  bool fits(const Vec2& at) const {
    if (std::max(std::abs(at.x()), std::abs(at.y())) > kRoom - 0.15) return false;
    return !closed_ || (at - Vec2(0, std::min(at.y(), kGate))).norm() > 0.15 + kThick;
  }
  bool bent(const Vec2& root, const Vec2& tip) const {
    if (std::max(std::abs(tip.x()), std::abs(tip.y())) > kRoom) return true;
    if (!closed_ || std::abs(root.x()) <= kThick) return closed_ && tip.y() < kGate && std::abs(tip.x()) < kThick;
    const double face = std::copysign(kThick, root.x());
    if ((root.x() - face) * (tip.x() - face) > 0) return false;
    return root.y() + (root.x() - face) / (root.x() - tip.x()) * (tip.y() - root.y()) < kGate;
  }
  void sense() {
    const Vec2 at = seen_.odometry.pose.position();
    for (int i = 0; i < 24; ++i) {
      const SinCos t = sin_cos(i * kPi / 12);
      seen_.readings.whisker[static_cast<std::size_t>(i)] = bent(at, at + 0.3 * Vec2(t.cos, t.sin));
      const Vec2 way = Vec2(1, 1.2) - at;
      const SinCos off = sin_cos(angle_of(way.y(), way.x()) - i * kPi / 12);
      seen_.readings.light[static_cast<std::size_t>(i)] = std::max(0.0, off.cos) / (1 + 0.3 * way.squaredNorm());
    }
  }

  Navigator drive_;
  Observation seen_;
  bool closed_ = false;
};

using Pair = std::pair<std::uint64_t, std::uint64_t>;

Pair serials(const CellPool& cells, int a, int b) { return std::minmax(cells[a].serial, cells[b].serial); }

template <class Visit>
void each_link(const CellPool& cells, const Visit& visit) {
  for (int cell = 0; cell < cells.slots(); ++cell)
    for (const Link& link : cells[cell].links)
      if (cell < link.to) visit(cell, link);
}

/// Links through the wall, not suspended. Round its end links cut the corner.
int left_through(const TopologicMap& map) {
  int left = 0;
  const CellPool& cells = map.net().cells();
  each_link(cells, [&](int cell, const Link& link) {
    const Vec2 a = cells[cell].position, b = cells[link.to].position;
    if (link.suspended || a.x() * b.x() >= 0) return;
    left += a.y() + a.x() / (a.x() - b.x()) * (b.y() - a.y()) < kGate - 0.5;
  });
  return left;
}

/// Tries links until none is due; which ones. Empty when there is no end of it.
std::set<Pair> try_all(SquareRoom& room, TopologicMap& map, Revisit& revisit) {
  std::set<Pair> tried;
  WhiskerContacts contacts(24);
  for (int i = 0; i < 40000; ++i) {
    map.step(room.seen());
    contacts.update(room.seen(), {});
    auto place = revisit.next(contacts);
    while (!place) {
      if (!revisit.begin()) return tried;
      tried.insert(serials(map.net().cells(), revisit.link()->first, revisit.link()->second));
      place = revisit.next(contacts);
    }
    room.go(inverse(map.map_from_odometry()) * *place);
  }
  return {};
}

std::shared_ptr<TopologicMap> made_map(SquareRoom& room, std::uint64_t seed, double share = 0) {
  auto map = std::make_shared<TopologicMap>(fresh_map());
  Guide guide = wander(map, {.samples = 1000000, .seed = seed, .revisit = {.share = share}});
  room.follow(guide, 2000);
  room.close(true);
  room.follow(guide, 1500);
  return map;
}

TEST(Revisit, WhenNothingIsDueEveryDoubtedLinkWasTried) {
  int doubted = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SquareRoom room;
    const auto map = made_map(room, seed);
    Revisit revisit(map, {.tries = 1, .pause = 0});
    const std::set<Pair> tried = try_all(room, *map, revisit);
    EXPECT_FALSE(tried.empty());
    each_link(map->net().cells(), [&](int cell, const Link& link) {
      if (link.doubt == 0) return;
      ++doubted;
      EXPECT_TRUE(tried.contains(serials(map->net().cells(), cell, link.to))) << seed;
    });
  }
  EXPECT_GT(doubted, 0);
}

TEST(Revisit, LinksThroughAWallGoAndComeBackWithIt) {
  int before = 0, after = 0, again = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SquareRoom room;
    const auto map = made_map(room, seed);
    before += left_through(*map);
    Revisit revisit(map, {.pause = 0});
    try_all(room, *map, revisit);
    after += left_through(*map);
    room.close(false);
    Revisit anew(map, {.pause = 0});
    try_all(room, *map, anew);
    again += left_through(*map);
  }
  EXPECT_LE(after, before);
  EXPECT_GT(again, after);
  RecordProperty("links", std::to_string(before) + " " + std::to_string(after) + " " + std::to_string(again));
}

TEST(Revisit, ExploringWithItIsTheSameEachTimeAndWithoutAShareAsBefore) {
  const auto text = [](double share) {
    SquareRoom room;
    return map_text(*made_map(room, 3, share));
  };
  EXPECT_EQ(text(0.5), text(0.5));
  EXPECT_NE(text(0.5), text(0));
}

TEST(Revisit, AllocatesNothingOnItsWay) {
  SquareRoom room;
  const auto map = made_map(room, 2);
  Revisit revisit(map, {});
  WhiskerContacts contacts(24);
  int driven = 0;
  for (int tries = 0; tries < 20 && revisit.begin(); ++tries)
    for (std::optional<Vec2> place = Vec2(0, 0); place; ++driven) {
      map->step(room.seen());
      contacts.update(room.seen(), {});
      const std::size_t before = allocations();
      place = revisit.next(contacts);
      if (place) {
        ASSERT_EQ(allocations(), before);
        room.go(inverse(map->map_from_odometry()) * *place);
      }
    }
  EXPECT_GT(driven, 20);
}

TEST(Revisit, ARobotThatDoesNotObeyIsGivenUp) {
  // Links and cells go at any time under a robot that goes where it likes.
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    TopologicMapOptions options;
    options.net.fade = 0.9;
    const auto map = std::make_shared<TopologicMap>(options, SenseSuite{});
    RoundRoom room(60 + seed);
    for (int i = 0; i < 1500; ++i) map->step(room.next());
    CellPool& cells = map->net().cells();
    for (int cell = 0; cell < cells.slots(); ++cell)
      for (std::size_t i = 0; i < cells[cell].links.size(); ++i) {
        Link link = cells[cell].links[i];
        link.doubt = 1;
        cells.connect(cell, link.to, link);
      }
    Revisit revisit(map, {.patience = 5});
    WhiskerContacts contacts(24);
    int most = 0;
    for (int drive = 0; drive < 40 && revisit.begin(); ++drive) {
      int samples = 0;
      for (std::optional<Vec2> place; samples == 0 || place; ++samples) {
        const Observation& seen = room.next();
        map->step(seen);
        contacts.update(seen, {});
        place = revisit.next(contacts);
        ASSERT_LT(samples, 20000);
      }
      most = std::max(most, samples);
    }
    EXPECT_GT(most, 0);
  }
}

TEST(Revisit, AMapWhoseLinksAreNeverSuspendedHasNothingToTry) {
  TopologicMapOptions options;
  options.doubt.suspend = 0;
  const auto map = std::make_shared<TopologicMap>(options, SenseSuite{});
  Revisit revisit(map, {});
  EXPECT_FALSE(revisit.begin());
  EXPECT_FALSE(revisit.next(WhiskerContacts(24)));
  EXPECT_FALSE(revisit.link());
  RoundRoom room(70);
  for (int i = 0; i < 1500; ++i) map->step(room.next());
  EXPECT_FALSE(revisit.begin());
}

}  // namespace
}  // namespace meander::topology

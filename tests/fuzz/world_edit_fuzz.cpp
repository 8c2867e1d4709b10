// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Bytes as a sequence of edits with any numbers: refused ones leave no trace, undo and redo walk through the same
// states, replaying the log and reading the written file give an equal world.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "world/editing.hpp"
#include "world/world_diff.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

constexpr int kAll = std::numeric_limits<int>::max();

void require(bool holds) {
  if (!holds) std::abort();
}

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool empty() const { return size_ == 0; }
  int byte() {
    if (empty()) return 0;
    --size_;
    return *data_++;
  }
  /// Small multiples of 1/8 mostly; any bit pattern after byte 255.
  double number() {
    const int b = byte();
    if (b != 255) return (b - 64) / 8.0;
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | static_cast<std::uint64_t>(byte());
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  Vec2 point() {
    const double x = number();
    return {x, number()};
  }
  std::vector<Vec2> points() {
    std::vector<Vec2> result(static_cast<std::size_t>(byte() % 8));
    for (Vec2& p : result) p = point();
    return result;
  }
  std::string name() {
    std::string result(static_cast<std::size_t>(byte() % 4), ' ');
    for (char& c : result) c = static_cast<char>(byte());
    return result;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

Shape shape(Bytes& in) {
  switch (in.byte() % 4) {
    case 0: {
      Chain chain{in.points(), false};
      chain.closed = in.byte() % 2 != 0;
      return chain;
    }
    case 1: {
      Polygon polygon{in.points(), {}};
      for (int holes = in.byte() % 3; holes > 0; --holes) polygon.holes.push_back(in.points());
      return polygon;
    }
    case 2: {
      Rectangle rectangle{in.point(), {}, 0};
      rectangle.size = in.point();
      rectangle.heading = in.number();
      return rectangle;
    }
    default: {
      Disc disc{in.point(), 0};
      disc.radius = in.number();
      return disc;
    }
  }
}

Item item(Bytes& in) {
  const std::string name = in.name();
  switch (in.byte() % 5) {
    case 0:
      return Obstacle{name, shape(in), {in.byte() / 200.0, {}}};
    case 1:
      return Door{name, shape(in), in.byte() % 2 != 0, {1, in.number()}};
    case 2: {
      Mover mover{name, {in.point(), 0.25}, Motion::waypoints, {}, 0.5, true};
      mover.waypoints = in.points();
      mover.speed = in.number();
      return mover;
    }
    case 3:
      return Light{name, in.point(), 1};
    default: {
      Place place{name, in.point(), {}, 0.25};
      if (in.byte() % 2) place.heading = in.number();
      return place;
    }
  }
}

Header header(Bytes& in) {
  Header header{in.name(), in.name(), {}, {}};
  header.bounds.low = in.point();
  header.bounds.high = in.point();
  if (in.byte() % 2) header.start = Pose2{in.number(), in.number(), in.number()};
  return header;
}

void edit(Bytes& in, World& world, int depth) {
  const int choice = in.byte() % 12;
  const auto ids = world.ids();
  const Id id = ids.empty() ? Id{} : ids[static_cast<std::size_t>(in.byte()) % ids.size()];
  switch (choice) {
    case 0:
      return world.remove(id);
    case 1:
      return world.replace(id, item(in));
    case 2:
      return world.set_header(header(in));
    case 3:
      return move(world, {id}, in.point());
    case 4:
      return turn(world, matching(world, in.name()), in.number());
    case 5:
      return scale(world, matching(world, "*"), in.number());
    case 6:
      return snap(world, ids, in.number());
    case 7:
      return rename(world, id, in.name());
    case 8:
      return set_open(world, id, in.byte() % 2 != 0);
    case 9:
      if (depth >= 3) return;
      return world.transaction([&] {
        for (int count = in.byte() % 6; count > 0; --count) edit(in, world, depth + 1);
      });
    default:
      world.add(item(in));
  }
}

/// A refused edit changes nothing; returns whether the edit was done.
void try_edit(Bytes& in, World& world) {
  const World before = world;
  try {
    edit(in, world, 0);
  } catch (const Error&) {
    require(world == before && world.history().size() == before.history().size());
  }
}

void check_laws(const World& world) {
  World replayed;
  replayed.transaction([&] {
    for (const Edit& e : world.log()) replayed.apply(e);
  });
  require(replayed == world && replayed.hash() == world.hash());
  require(world_from_toml(to_toml(world)) == world);
  require(difference(replayed, world).empty());
  World walked = world;
  const int steps = walked.undo(kAll);
  require(walked.redo(steps) == steps && walked == world && walked.ids() == world.ids());
  static_cast<void>(world_script(world));
}

}  // namespace
}  // namespace meander

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meander;
  constexpr std::size_t kMostBytes = 2000;
  Bytes in(data, std::min(size, kMostBytes));
  World world;
  while (!in.empty()) {
    const int choice = in.byte();
    if (choice < 32)
      world.undo(choice % 4);
    else if (choice < 48)
      world.redo(choice % 4);
    else
      try_edit(in, world);
  }
  check_laws(world);
  return 0;
}

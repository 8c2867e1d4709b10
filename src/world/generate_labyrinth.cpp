// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/generate_labyrinth.hpp"

#include "base/random.hpp"

namespace meander {
namespace {

/// To the micrometre, so that files are pleasant to read.
Vec2 rounded(const Vec2& at) { return (at * 1e6).array().round() / 1e6; }

/// Draws the walls as runs of corners, those along x first.
class Mason {
 public:
  Mason(const Labyrinth& labyrinth, const LabyrinthWalls& walls, std::uint64_t seed)
      : labyrinth_(labyrinth),
        jittered_(walls.jitter > 0),
        corners_(labyrinth.columns() + 1, labyrinth.rows() + 1, Vec2(0, 0)) {
    Stream stream(seed, "labyrinth walls");
    for (int y = 0; y <= labyrinth.rows(); ++y)
      for (int x = 0; x <= labyrinth.columns(); ++x) {
        const double dx = stream.uniform(-walls.jitter, walls.jitter), dy = stream.uniform(-walls.jitter, walls.jitter);
        const bool inner = x > 0 && y > 0 && x < labyrinth.columns() && y < labyrinth.rows();
        corners_[{x, y}] = rounded(walls.corridor * (Vec2(x, y) + (inner ? Vec2(dx, dy) : Vec2(0, 0))));
      }
  }

  void build(World& world) {
    const int columns = labyrinth_.columns(), rows = labyrinth_.rows();
    wall(world, "outer_wall", {{0, 0}, {columns, 0}, {columns, rows}, {0, rows}}, true);
    for (int y = 1; y < rows; ++y) runs(world, {0, y}, columns, 0);
    for (int x = 1; x < columns; ++x) runs(world, {x, 0}, rows, 1);
  }

 private:
  /// The walls on a line of corners that goes east (side 0) or north (side 1): each piece lies left of cells of which
  /// it bounds one side.
  void runs(World& world, Cell first, int pieces, int along) {
    std::vector<Cell> run{first};
    Cell corner = first;
    for (int i = 0; i < pieces; ++i, corner = beside(corner, along)) {
      const int across = along == 0 ? 3 : 2;  // the wall is the south or west side of the cell at its first corner
      if (!labyrinth_.open(corner, across)) {
        run.push_back(beside(corner, along));
        continue;
      }
      finish(world, run);
      run = {beside(corner, along)};
    }
    finish(world, run);
  }
  void finish(World& world, std::vector<Cell> run) {
    if (run.size() < 2) return;
    if (!jittered_) run.erase(run.begin() + 1, run.end() - 1);
    wall(world, fmt::format("wall_{}", ++count_), run, false);
  }
  void wall(World& world, const std::string& name, const std::vector<Cell>& corners, bool closed) {
    Chain line;
    line.closed = closed;
    for (const Cell corner : corners) line.points.push_back(corners_[corner]);
    world.add(Obstacle{.name = name, .shape = std::move(line), .surface = {}});
  }

  const Labyrinth& labyrinth_;
  bool jittered_;
  Grid<Vec2> corners_;
  int count_ = 0;
};

}  // namespace

World labyrinth_world(const Labyrinth& labyrinth, const LabyrinthWalls& walls, std::uint64_t seed) {
  validate(walls);
  const double side = walls.corridor;
  Header header;
  header.title = "labyrinth";
  header.bounds = {{0, 0}, rounded(side * Vec2(labyrinth.columns(), labyrinth.rows()))};
  const double heading = labyrinth.open({0, 0}, 0) ? 0 : kPi / 2;
  header.start = Pose2{side / 2, side / 2, heading};
  World world(header);
  Mason(labyrinth, walls, seed).build(world);
  const Vec2 goal = rounded(header.bounds.high - side * Vec2(0.5, 0.5));
  world.add(Place{.name = "goal", .position = goal, .heading = {}, .tolerance = 0.25});
  world.forget_history();
  return world;
}

}  // namespace meander

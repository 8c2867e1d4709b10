// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/generate_clutter.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "grid/flood.hpp"

namespace meander {
namespace {

constexpr int kMisses = 10000;       ///< objects of a draw that may find no room
constexpr double kCorner = 0.8;      ///< start and goal are so far from the walls' middle [m]
constexpr double kWall = 0.1;        ///< thickness [m]
constexpr double kCell = 0.05;       ///< of the raster on which routes are looked for [m]
constexpr double kTolerance = 0.25;  ///< of the goal [m]

/// Calls visit(cell) for the cells whose centre may be within `reach` of the shape.
template <class Visit>
void for_cells_near(const Grid<std::uint8_t>& grid, const Shape& shape, double reach, Visit visit) {
  const Box box = bounding_box(shape);
  const Vec2 more(reach, reach);
  const Cell low = grid.frame.cell(box.low - more), high = grid.frame.cell(box.high + more);
  for (int y = std::max(0, low.y); y <= std::min(grid.height() - 1, high.y); ++y)
    for (int x = std::max(0, low.x); x <= std::min(grid.width() - 1, high.x); ++x) visit(Cell{x, y});
}

std::vector<Obstacle> walls(const Vec2& size) {
  const double w = size.x(), h = size.y();
  const auto wall = [](const char* name, const Vec2& center, const Vec2& extent) {
    return Obstacle{.name = name, .shape = Rectangle{center, extent, 0}, .surface = {}};
  };
  return {wall("wall_south", {w / 2, 0}, {w + kWall, kWall}), wall("wall_north", {w / 2, h}, {w + kWall, kWall}),
          wall("wall_west", {0, h / 2}, {kWall, h - kWall}), wall("wall_east", {w, h / 2}, {kWall, h - kWall})};
}

class Drawer {
 public:
  explicit Drawer(const ClutterOptions& options)
      : options_(options),
        size_(options.width, options.height),
        goal_(size_ - start_),
        stream_(options.seed, "clutter") {}

  /// Objects until they cover enough; nothing when there is no room for them.
  std::optional<std::vector<Shape>> draw() {
    std::vector<Shape> shapes;
    Grid<std::uint8_t> covered = raster(0);
    const double wanted = options_.density * static_cast<double>(covered.cells().size());
    int misses = 0;
    for (double count = 0; count < wanted;) {
      const Shape shape = object();
      if (!fits(shape)) {
        if (++misses > kMisses) return std::nullopt;
        continue;
      }
      shapes.push_back(shape);
      for_cells_near(covered, shape, 0, [&](Cell cell) {
        if (covered[cell] || !contains(shape, covered.frame.center(cell))) return;
        covered[cell] = 1;
        ++count;
      });
    }
    return shapes;
  }

  bool has_route(const std::vector<Shape>& shapes) const {
    Grid<std::uint8_t> open = raster(1);
    for (const Obstacle& wall : walls(size_)) close(open, wall.shape);
    for (const Shape& shape : shapes) close(open, shape);
    const Grid<std::int32_t> label = components(open, Neighbours::four).label;
    const std::int32_t here = label[open.frame.cell(start_)];
    return here >= 0 && here == label[open.frame.cell(goal_)];
  }

  World world(const std::vector<Shape>& shapes) const {
    Header header;
    header.title = fmt::format("clutter {:g} %, seed {}", 100 * options_.density, options_.seed);
    header.note = fmt::format(
        "Boxes and discs strewn at random over {:g} % of the ground. A way of {:g} m clearance leads to the goal.\n"
        "Source: drawn by meander's generator, seed {}; the setting is that of Lagoudakis and Maida, Neural maps for\n"
        "mobile robot navigation (1999), Figure 8 right.",
        100 * options_.density, options_.route, options_.seed);
    header.bounds = {{0, 0}, size_};
    const Vec2 ahead = goal_ - start_;
    header.start = Pose2{start_.x(), start_.y(), angle_of(ahead.y(), ahead.x())};
    World world(header);
    for (const Obstacle& wall : walls(size_)) world.add(wall);
    int number = 0;
    for (const Shape& shape : shapes) {
      const char* kind = std::holds_alternative<Disc>(shape) ? "disc" : "box";
      world.add(Obstacle{.name = fmt::format("{}_{}", kind, ++number), .shape = shape, .surface = {}});
    }
    world.add(Place{"goal", goal_, {}, kTolerance});
    world.forget_history();
    return world;
  }

 private:
  Shape object() {
    const Vec2 at(stream_.uniform(0, size_.x()), stream_.uniform(0, size_.y()));
    if (!stream_.chance(options_.boxes))
      return Disc{at, stream_.uniform(options_.disc_radius_min, options_.disc_radius_max)};
    const double along = stream_.uniform(options_.box_side_min, options_.box_side_max);
    const double across = stream_.uniform(options_.box_side_min, options_.box_side_max);
    return Rectangle{at, {along, across}, stream_.uniform(-kPi / 2, kPi / 2)};
  }

  Grid<std::uint8_t> raster(std::uint8_t fill) const {
    return {static_cast<int>(size_.x() / kCell), static_cast<int>(size_.y() / kCell), fill, {kCell, {}}};
  }

  /// Within the walls, and start and goal keep their room.
  bool fits(const Shape& shape) const {
    const Box box = bounding_box(shape);
    if ((box.low - inner_).minCoeff() < 0 || (size_ - inner_ - box.high).minCoeff() < 0) return false;
    const double room = options_.route + kCell;
    return distance(shape, start_) >= room && distance(shape, goal_) >= room;
  }

  /// Half a cell more than the route: between two neighbours that are open, so much may be missing.
  void close(Grid<std::uint8_t>& open, const Shape& shape) const {
    const double keep = options_.route + kCell / 2;
    for_cells_near(open, shape, keep, [&](Cell cell) {
      if (open[cell] && distance(shape, open.frame.center(cell)) < keep) open[cell] = 0;
    });
  }

  const ClutterOptions& options_;
  Vec2 size_;
  Vec2 inner_{kWall / 2, kWall / 2};
  Vec2 start_{kCorner, kCorner};
  Vec2 goal_;
  Stream stream_;
};

void check_order(const char* what, double least, double most) {
  if (least > most) fail("{}_min: at most {}_max = {} expected, got {}", what, what, most, least);
}

}  // namespace

std::optional<World> generate_clutter(const ClutterOptions& options, const Work& work) {
  validate(options);
  check_order("disc_radius", options.disc_radius_min, options.disc_radius_max);
  check_order("box_side", options.box_side_min, options.box_side_max);
  Drawer drawer(options);
  if (!drawer.has_route({})) return std::nullopt;  // the walls alone are too near
  for (int draw = 0; draw < options.draws; ++draw) {
    work.poll();
    const auto shapes = drawer.draw();
    if (shapes && drawer.has_route(*shapes)) return drawer.world(*shapes);
  }
  return std::nullopt;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_world.hpp"

#include <cmath>

#include "render/clip.hpp"
#include "render/draw_parts.hpp"
#include "render/viewport.hpp"

namespace meander {
namespace {

std::vector<Vec2> corners(const Box& box) {
  return {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
}

void draw_grid_lines(DrawList& list, const Box& bounds, double unit, Color color) {
  const double step = round_length(12 * unit);
  const auto line = [&](Vec2 a, Vec2 b) {
    list.items.push_back(DrawPolyline{{a, b}, false, 0.12 * unit, color, Mark::grid});
  };
  for (double x = std::ceil(bounds.low.x() / step) * step; x <= bounds.high.x(); x += step)
    line({x, bounds.low.y()}, {x, bounds.high.y()});
  for (double y = std::ceil(bounds.low.y() / step) * step; y <= bounds.high.y(); y += step)
    line({bounds.low.x(), y}, {bounds.high.x(), y});
}

/// Below the floor: how long a round number of metres is, and what the picture shows.
void draw_scale(DrawList& list, const Box& bounds, const std::string& caption, double unit, const Theme& theme) {
  const double length = round_length(0.25 * bounds.size().x());
  const Vec2 from = bounds.low - Vec2(0, 3 * unit);
  const Vec2 to = from + Vec2(length, 0);
  const Vec2 tick(0, 0.7 * unit);
  list.items.push_back(DrawPolyline{{from + tick, from, to, to + tick}, false, 0.25 * unit, theme.muted, Mark::label});
  list.items.push_back(DrawText{to + Vec2(unit, 0), fmt::format("{:g} m", length), 1.3 * unit, theme.muted});
  if (!caption.empty())
    list.items.push_back(
        DrawText{{bounds.high.x(), from.y()}, caption, 1.3 * unit, theme.muted, {0, 0, 0, 0}, Align::right});
}

/// Draws the things of a world, each kind in its own way.
class Painter {
 public:
  Painter(DrawList& list, const WorldLook& look)
      : list_(list), look_(look), theme_(theme(look.background)), unit_(picture_unit(list.view)) {}

  void draw(const Obstacle& obstacle) { solid(obstacle.shape, theme_.wall, Mark::wall); }

  void draw(const Door& door) {
    if (!door.open) return solid(door.shape, theme_.door, Mark::door);
    for (const Ring& ring : rings(outlined(door.shape)))
      draw_dashed(list_, ring.points, ring.closed, 0.6 * unit_, 0.2 * unit_, theme_.open_door, Mark::open_door);
  }

  void draw(const Mover& mover) {
    if (!look_.movers) return;
    if (mover.motion == Motion::waypoints && !mover.waypoints.empty()) {
      std::vector<Vec2> way{mover.disc.center};
      way.insert(way.end(), mover.waypoints.begin(), mover.waypoints.end());
      draw_dashed(list_, way, true, 0.8 * unit_, 0.2 * unit_, faded(theme_.mover, 150), Mark::ground);
    }
    list_.items.push_back(DrawBody{mover.disc, std::nullopt, theme_.mover, theme_.floor, Mark::mover});
  }

  void draw(const Light& light) {
    for (const double radius : {3.2, 2.2, 1.4})
      list_.items.push_back(DrawDisc{{light.position, radius * unit_}, faded(theme_.light, 70), Mark::light});
    list_.items.push_back(DrawDisc{{light.position, 0.8 * unit_}, theme_.echo, Mark::light});
    list_.items.push_back(DrawDisc{{light.position, 0.55 * unit_}, theme_.light, Mark::light});
  }

  void draw(const Place& place) {
    list_.items.push_back(DrawDisc{{place.position, place.tolerance}, faded(theme_.place, 36), Mark::ground});
    list_.items.push_back(DrawDisc{{place.position, 0.6 * unit_}, theme_.place, Mark::place, 0.25 * unit_});
    if (place.heading) {
      const Vec2 way = Pose2{0, 0, *place.heading}.direction();
      line({place.position + 0.6 * unit_ * way, place.position + 1.8 * unit_ * way}, theme_.place, Mark::place);
    }
    if (look_.names) text(place.position + Vec2(0, 1.7 * unit_), place.name);
  }

  void draw_start(const Pose2& start) {
    list_.items.push_back(DrawDisc{{start.position(), 1.1 * unit_}, theme_.start, Mark::start, 0.3 * unit_});
    line({start.position(), start * Vec2(2.2 * unit_, 0)}, theme_.start, Mark::start);
  }

 private:
  /// Discs as a closed chain, the rest as it is: dashes need corners.
  static Shape outlined(const Shape& shape) {
    const Disc* disc = std::get_if<Disc>(&shape);
    return disc ? Shape(Chain{circle(*disc, 20), true}) : shape;
  }

  void solid(const Shape& shape, Color color, Mark mark) {
    if (const Disc* disc = std::get_if<Disc>(&shape)) {
      list_.items.push_back(DrawDisc{*disc, color, mark});
    } else if (const Polygon* polygon = std::get_if<Polygon>(&shape)) {
      list_.items.push_back(DrawArea{*polygon, color, mark});
    } else if (const Chain* chain = std::get_if<Chain>(&shape)) {
      list_.items.push_back(DrawPolyline{chain->points, chain->closed, 0.35 * unit_, color, mark});
    } else {
      list_.items.push_back(DrawArea{{rings(shape).front().points, {}}, color, mark});
    }
  }

  void line(std::vector<Vec2> points, Color color, Mark mark) {
    list_.items.push_back(DrawPolyline{std::move(points), false, 0.3 * unit_, color, mark});
  }

  void text(const Vec2& at, const std::string& words) {
    list_.items.push_back(DrawText{at, words, 1.3 * unit_, theme_.label, faded(theme_.floor, 200), Align::center});
  }

  DrawList& list_;
  const WorldLook& look_;
  const Theme& theme_;
  double unit_;
};

}  // namespace

DrawList draw_floor(const Box& bounds, const std::string& caption, const WorldLook& look) {
  const Theme& colors = theme(look.background);
  const double unit = picture_unit(usable_view(bounds));
  DrawList list;
  list.background = colors.background;
  const double margin = 2 * unit;
  list.view = {bounds.low - Vec2(margin, look.scale ? 4.5 * unit : margin), bounds.high + Vec2(margin, margin)};
  list.items.push_back(DrawArea{{corners(bounds), {}}, colors.floor, Mark::ground});
  if (look.grid) draw_grid_lines(list, bounds, unit, colors.grid);
  list.items.push_back(DrawPolyline{corners(bounds), true, 0.12 * unit, colors.bounds, Mark::grid});
  if (look.scale && bounds.size().x() > 0) draw_scale(list, bounds, caption, unit, colors);
  return list;
}

DrawList draw_world(const World& world, const WorldLook& look) {
  const Header& header = world.header();
  DrawList list = draw_floor(header.bounds, header.title, look);
  Painter painter(list, look);
  for (const Id id : world.ids()) std::visit([&](const auto& thing) { painter.draw(thing); }, world.item(id));
  if (header.start) painter.draw_start(*header.start);
  return list;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_list.hpp"

#include <algorithm>
#include <cmath>

#include "render/theme.hpp"
#include "render/unicode.hpp"

namespace meander {
namespace {

bool finite(double value) { return std::abs(value) <= kDrawnReach; }  // false for NaN

bool finite(const Vec2& p) { return finite(p.x()) && finite(p.y()); }

bool finite(const std::vector<Vec2>& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec2& p) { return finite(p); });
}

bool drawable_item(const DrawPolyline& line) {
  return line.points.size() >= 2 && finite(line.points) && finite(line.width) && line.width >= 0;
}

bool drawable_item(const DrawArea& area) {
  const auto& holes = area.polygon.holes;
  return area.polygon.outer.size() >= 3 && finite(area.polygon.outer) &&
         std::all_of(holes.begin(), holes.end(), [](const auto& hole) { return finite(hole); });
}

bool drawable_item(const DrawDisc& disc) {
  return finite(disc.disc.center) && finite(disc.disc.radius) && disc.disc.radius > 0 && finite(disc.line) &&
         disc.line >= 0;
}

bool drawable_item(const DrawText& text) {
  return finite(text.at) && finite(text.height) && text.height > 0 && !text.text.empty();
}

bool drawable_item(const DrawCells& cells) {
  const auto count =
      static_cast<std::size_t>(std::max(cells.width, 0)) * static_cast<std::size_t>(std::max(cells.height, 0));
  return count > 0 && cells.colors.size() == count && (cells.marks.empty() || cells.marks.size() == count) &&
         finite(cells.resolution) && cells.resolution > 0 && finite(cells.origin.position()) &&
         finite(cells.origin.heading);
}

bool drawable_item(const DrawBody& body) {
  return drawable_item(DrawDisc{body.disc, body.color, body.mark}) && (!body.heading || finite(*body.heading));
}

}  // namespace

Mark mark_of(const DrawItem& item) {
  return std::visit(
      [](const auto& thing) {
        if constexpr (requires { thing.mark; })
          return thing.mark;
        else
          return Mark::cell;
      },
      item);
}

std::vector<const DrawItem*> painting_order(const DrawList& list) {
  std::vector<const DrawItem*> order;
  order.reserve(list.items.size());
  for (const DrawItem& item : list.items)
    if (drawable(item)) order.push_back(&item);
  std::stable_sort(order.begin(), order.end(),
                   [](const DrawItem* a, const DrawItem* b) { return mark_of(*a) < mark_of(*b); });
  return order;
}

bool drawable(const DrawItem& item) {
  return std::visit([](const auto& thing) { return drawable_item(thing); }, item);
}

std::vector<DrawItem> parts(const DrawBody& body) {
  const double r = body.disc.radius;
  std::vector<DrawItem> items{DrawDisc{body.disc, body.color, body.mark}};
  items.push_back(DrawDisc{{body.disc.center, 0.94 * r}, mixed(body.color, body.nose, 0.25), body.mark, 0.12 * r});
  if (!body.heading) return items;
  const Pose2 pose{body.disc.center.x(), body.disc.center.y(), *body.heading};
  const std::vector<Vec2> arrow{pose * Vec2(0.72 * r, 0), pose * Vec2(-0.36 * r, 0.5 * r), pose * Vec2(-0.14 * r, 0),
                                pose * Vec2(-0.36 * r, -0.5 * r)};
  items.push_back(DrawArea{{arrow, {}}, body.nose, body.mark});
  return items;
}

std::string printable(const std::string& text) {
  std::string clean;
  for (const char32_t code : code_points(text)) append_utf8(clean, is_control(code) ? kReplacement : code);
  return clean;
}

}  // namespace meander

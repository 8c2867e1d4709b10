// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_parts.hpp"

#include <algorithm>
#include <cmath>

namespace meander {

double picture_unit(const Box& view) { return 0.01 * std::max(view.size().x(), view.size().y()); }

double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most) return factor * power;
  return power;
}

void draw_dashed(DrawList& list, const std::vector<Vec2>& points, bool closed, double dash, double width, Color color,
                 Mark mark) {
  std::vector<Vec2> way = points;
  if (closed && !way.empty()) way.push_back(way.front());
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  if (!(length < 2000 * dash)) return list.items.push_back(DrawPolyline{points, closed, width, color, mark});
  double left = dash;  // of the running dash or gap
  bool drawing = true;
  std::vector<Vec2> run(way.begin(), way.begin() + std::min<std::ptrdiff_t>(1, std::ssize(way)));
  for (std::size_t i = 1; i < way.size();) {
    const Vec2 from = run.back();
    const double step = (way[i] - from).norm();
    const bool turns = step <= left;
    const Vec2 to = turns ? way[i] : Vec2(from + (way[i] - from) * (left / step));
    left -= std::min(step, left);
    run.push_back(to);
    if (turns) ++i;
    if (turns && i < way.size()) continue;
    if (drawing) list.items.push_back(DrawPolyline{run, false, width, color, mark});
    run = {to}, left = dash, drawing = !drawing;
  }
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_polar.hpp"

#include <cmath>

#include "base/error.hpp"
#include "render/draw_parts.hpp"
#include "render/draw_run.hpp"
#include "render/theme.hpp"

namespace meander {
namespace {

constexpr int kCells = 260;  ///< across the map
constexpr int kBands = 28;   ///< of the activation's logarithm: their borders are lines of equal activation
constexpr double kRim = 1.09;
constexpr double kKey = 2.55;  ///< right border of the key, in scopes

class PolarPainter {
 public:
  PolarPainter(const PolarNavigator& polar, DrawList& list)
      : polar_(polar),
        list_(list),
        layout_(polar.layout()),
        frame_(polar.odometry_from_map()),
        scope_(polar.layout().scope()),
        unit_(picture_unit(list.view)) {}

  void draw(const RobotLook& look) {
    units();
    readings(look);
    for (int age = 0; age < polar_.memory().scans(); ++age)
      for (const MemoryPoint& point : polar_.memory().scan(age))
        if (inside(point.position)) dot(point.position, 0.35, faded(colors_.wall, 110));
    for (const MappedPoint& point : polar_.points()) dot(frame_ * point.position, 0.55, colors_.contact);
    way();
    ray();
    robot(look);
    goals();
    key();
  }

 private:
  bool inside(const Vec2& p) const { return (p - frame_.position()).norm() <= scope_; }
  void dot(const Vec2& at, double size, Color color) {
    list_.items.push_back(DrawDisc{{at, size * unit_}, color, Mark::echo});
  }
  void circle(const Vec2& at, double radius, double width, Color color, Mark mark) {
    list_.items.push_back(DrawDisc{{at, radius}, color, mark, width * unit_});
  }
  void write(const Vec2& at, const std::string& text, Color color, Align align = Align::left) {
    list_.items.push_back(DrawText{at, text, 1.35 * unit_, color, faded(colors_.background, 220), align});
  }

  /// The least logarithm of an activation anywhere.
  double least() const {
    double least = 0;
    for (int sector = 0; sector < layout_.sectors(); ++sector)
      for (int ring = 0; ring < layout_.rings(); ++ring)
        if (const double a = polar_.solver().activation(ring, sector); a > 0) least = std::min(least, std::log10(a));
    return std::min(least, -1e-9);
  }

  Color shade(double share) const {
    const double band = std::clamp(std::floor(share * kBands) / (kBands - 1), 0.0, 1.0);
    return mixed(mixed(colors_.goal, colors_.wall, 0.15), {236, 246, 240}, std::sqrt(band));
  }
  Color blocked() const { return mixed(colors_.floor, colors_.wall, 0.62); }
  Color unreached() const { return mixed(colors_.background, colors_.wall, 0.12); }

  void units() {
    const double least = this->least();
    DrawCells cells{{frame_.x - scope_, frame_.y - scope_, 0}, 2 * scope_ / kCells, kCells, kCells, {}, {}};
    const Pose2 map_from_odometry = inverse(frame_);
    for (int y = 0; y < kCells; ++y)
      for (int x = 0; x < kCells; ++x) {
        const Vec2 at = map_from_odometry * (cells.origin * (cells.resolution * Vec2(x + 0.5, y + 0.5)));
        const double r = at.norm();
        const int ring = layout_.nearest_ring(std::min(r, scope_));
        const int sector = layout_.nearest_sector(angle_of(at.y(), at.x()));
        const bool wall = polar_.obstructed().test(ring, sector) && r <= scope_;
        const double a = polar_.solver().activation(ring, sector);
        cells.marks.push_back(wall ? Mark::wall : Mark::cell);
        cells.colors.push_back(r > scope_ ? Color{0, 0, 0, 0}
                               : wall     ? blocked()
                               : a > 0    ? shade(std::log10(a) / least)
                                          : unreached());
      }
    list_.items.push_back(std::move(cells));
    circle(frame_.position(), scope_, 0.2, colors_.muted, Mark::grid);
  }

  /// Those that heard something within the map.
  void readings(const RobotLook& look) {
    std::vector<Pose2> transducers;
    std::vector<double> ranges;
    for (const SonarMemory::Beam& beam : polar_.memory().beams()) {
      if (beam.reading >= look.range_max || !inside(beam.from + beam.reading * beam.axis)) continue;
      transducers.push_back({beam.from.x(), beam.from.y(), angle_of(beam.axis.y(), beam.axis.x())});
      ranges.push_back(beam.reading);
    }
    draw_readings(list_, {transducers, ranges, look.half_cone, look.range_max}, colors_);
  }

  /// The chosen direction as far as activation rises along it: to the subgoal.
  void ray() {
    if (const auto& chosen = polar_.subgoal())
      draw_dashed(list_, {frame_.position(), frame_ * chosen->position}, false, 0.9 * unit_, 0.3 * unit_, colors_.path,
                  Mark::path);
  }

  /// Steepest ascent from the read-out on, unit after unit: the way that the map means.
  void way() {
    const auto& chosen = polar_.subgoal();
    if (!chosen) return;
    int ring = std::min(chosen->ring, layout_.nearest_ring(polar_.options().subgoal.read_radius));
    int sector = chosen->sector;
    std::vector<Vec2> points{frame_.position()};
    for (int steps = layout_.rings() + layout_.sectors(); steps > 0; --steps) {
      points.push_back(frame_ * layout_.position(ring, sector));
      int best_ring = ring, best_sector = sector;
      for (int r = std::max(0, ring - 1); r <= std::min(ring + 1, layout_.rings() - 1); ++r)
        for (int turn = -1; turn <= 1; ++turn) {
          const int s = layout_.wrapped(sector + turn);
          if (polar_.solver().activation(r, s) <= polar_.solver().activation(best_ring, best_sector)) continue;
          best_ring = r, best_sector = s;
        }
      if (best_ring == ring && best_sector == sector) break;
      ring = best_ring, sector = best_sector;
    }
    list_.items.push_back(DrawPolyline{std::move(points), false, 0.35 * unit_, colors_.path, Mark::path});
  }

  void robot(const RobotLook& look) {
    const Pose2& now = polar_.predicted().pose;
    draw_robot(list_, now, look.radius, colors_);
    const Vec2 end = frame_ * polar_.control().chosen().end.position();
    std::vector<Vec2> rim;
    for (int k = 0; k < 48; ++k) {
      const SinCos t = sin_cos(2 * kPi * k / 48);
      rim.push_back(end + look.radius * Vec2(t.cos, t.sin));
    }
    draw_dashed(list_, rim, true, 0.9 * unit_, 0.3 * unit_, colors_.robot, Mark::robot);
  }

  void goals() {
    const bool beyond = polar_.target().x() > scope_;
    const Vec2 target = frame_ * Vec2(std::min(polar_.target().x(), scope_), 0);
    if (beyond) {
      const Vec2 tip = frame_ * Vec2(1.05 * scope_, 0);
      const double s = 0.03 * scope_;
      list_.items.push_back(
          DrawArea{{{tip, frame_ * Vec2(scope_, -s), frame_ * Vec2(scope_, s)}, {}}, colors_.goal, Mark::goal});
    } else {
      list_.items.push_back(DrawDisc{{target, 1.1 * unit_}, colors_.goal, Mark::goal});
    }
    if (const auto& chosen = polar_.subgoal()) {
      const Vec2 at = frame_ * chosen->position;
      list_.items.push_back(DrawDisc{{at, 1.1 * unit_}, colors_.path, Mark::goal});
      list_.items.push_back(DrawDisc{{at, 0.5 * unit_}, colors_.floor, Mark::goal});
    }
  }

  /// What is what, to the right of the map.
  void key() {
    left_ = frame_.x + 1.2 * scope_;
    line_ = frame_.y + 0.86 * scope_;
    entry(fmt::format("{}, {:.2f} m away", polar_.trap().temporary() ? "temporary target" : "target",
                      polar_.target().x()));
    disc(1.1, colors_.goal);
    entry(polar_.subgoal()
              ? fmt::format("subgoal, {:+.0f} deg from there", degrees(layout_.bearing(polar_.subgoal()->sector)))
              : "no subgoal: no way");
    disc(1.1, colors_.path);
    disc(0.5, colors_.floor);
    entry("way of steepest ascent");
    bar(0.35, colors_.path);
    entry("ray: most active at subgoal");
    for (int dash = -1; dash <= 1; ++dash) bar(0.3, colors_.path, 1.1 * dash, 0.35);
    entry("robot (dashed: its next stop)");
    disc(1.2, colors_.robot);
    entry("echoes of the last scan");
    bar(0.5, colors_.echo);
    entry("points on the map");
    disc(0.55, colors_.contact);
    entry("remembered, left out");
    disc(0.35, faded(colors_.wall, 110));
    entry("obstructed units of the map");
    square(blocked());
    entry("units without activation");
    square(unreached());
    scale();
  }
  void entry(const std::string& text) {
    line_ -= 3.6 * unit_;
    write({left_ + 3 * unit_, line_ - 0.7 * unit_}, text, colors_.label);
  }
  void disc(double size, Color color) {
    list_.items.push_back(DrawDisc{{{left_, line_}, size * unit_}, color, Mark::goal});
  }
  void bar(double width, Color color, double at = 0, double half = 1.3) {
    list_.items.push_back(DrawPolyline{{{left_ + (at - half) * unit_, line_}, {left_ + (at + half) * unit_, line_}},
                                       false,
                                       width * unit_,
                                       color,
                                       Mark::path});
  }
  void square(Color color) { patch({left_ - 1.2 * unit_, line_ - 1.2 * unit_}, 2.4 * unit_, color); }
  void patch(const Vec2& low, double width, Color color) {
    const Vec2 high = low + Vec2(width, 2.4 * unit_);
    list_.items.push_back(DrawArea{{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}, color, Mark::ground});
  }
  /// The bar of the activation's shades, from the target's on.
  void scale() {
    line_ -= 4.5 * unit_;
    const double width = 28 * unit_ / kBands;
    for (int k = 0; k < kBands; ++k)
      patch({left_ - 1.2 * unit_ + k * width, line_}, 1.02 * width, shade((k + 0.5) / kBands));
    write({left_ - 1.2 * unit_, line_ - 2.4 * unit_}, "activation 1", colors_.muted);
    write({left_ + 26.8 * unit_, line_ - 2.4 * unit_}, fmt::format("1e{:.0f}", least()), colors_.muted, Align::right);
  }

  const PolarNavigator& polar_;
  DrawList& list_;
  const PolarLayout& layout_;
  const Pose2& frame_;
  double scope_;
  double unit_;
  double left_ = 0, line_ = 0;  ///< of the key's entry at hand
  const Theme& colors_ = theme(Background::light);
};

}  // namespace

DrawList draw_polar(const PolarNavigator& navigator, const RobotLook& look) {
  if (!navigator.mapped()) fail("the navigator has not driven yet: nothing to draw before its first step");
  const Vec2 centre = navigator.odometry_from_map().position();
  const double scope = navigator.layout().scope();
  DrawList list;
  list.background = theme(Background::light).background;
  list.view = {centre - kRim * Vec2(scope, scope), centre + Vec2(kKey * scope, kRim * scope)};
  PolarPainter(navigator, list).draw(look);
  return list;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/draw_parts.hpp"
#include "render/theme.hpp"

namespace meander {
namespace {

constexpr double kHeight = 50;      // of the field in units of the picture
constexpr double kLetter = 1.5;     // height of a capital letter
constexpr std::size_t kMost = 600;  // points of a curve; more are drawn as the range they cover

/// Farther out, the width of a range is not finite.
bool plottable(double value) { return std::abs(value) <= 1e300; }

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  bool empty() const { return !(low <= high); }
};

Range range_of(std::span<const double> values) {
  Range range;
  for (const double value : values)
    if (plottable(value)) range.add(value);
  if (values.empty()) fail("numbers to draw expected, got none");
  if (range.empty()) fail("numbers to draw expected, got {} that are not finite", values.size());
  return range;
}

/// A range with some width, so that it can be divided.
Range widened(Range range) {
  const double least = std::max({1e-9, 1e-9 * std::abs(range.low), 1e-9 * std::abs(range.high)});
  if (range.high - range.low < least) range.low -= 0.5, range.high += 0.5;
  return range;
}

/// The field of a plot with its axes: from numbers to the picture.
class Axes {
 public:
  Axes(const Range& x, const Range& y, double width, const PlotWords& words) : x_(x), y_(y), width_(width) {
    const Theme& colors = theme(Background::light);
    list.background = colors.background;
    list.view = {{-11, words.x.empty() ? -4.5 : -7.5},
                 {width + 4, kHeight + (words.title.empty() && words.y.empty() ? 2.5 : 5.5)}};
    list.items.emplace_back(DrawArea{{box({0, 0}, {width, kHeight}), {}}, colors.floor, Mark::ground});
    for (const double tick : round_ticks(x.low, x.high)) x_tick(tick, colors);
    for (const double tick : round_ticks(std::min(y.low, y.high), std::max(y.low, y.high))) y_tick(tick, colors);
    list.items.emplace_back(DrawPolyline{{{0, kHeight}, {0, 0}, {width, 0}}, false, 0.25, colors.muted, Mark::grid});
    write({0.5 * width, kHeight + 2}, words.title, colors.label, Align::center);
    write({0.5 * width, -6.5}, words.x, colors.muted, Align::center);
    write({-10, kHeight + 2}, words.y, colors.muted, Align::left);
  }

  Vec2 operator()(double x, double y) const {
    return {width_ * (x - x_.low) / (x_.high - x_.low), kHeight * (y - y_.low) / (y_.high - y_.low)};
  }

  static std::vector<Vec2> box(const Vec2& low, const Vec2& high) {
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  }

  void write(const Vec2& at, const std::string& text, Color color, Align align) {
    if (!text.empty()) list.items.emplace_back(DrawText{at, text, kLetter, color, {0, 0, 0, 0}, align});
  }

  DrawList list;

 private:
  void x_tick(double tick, const Theme& colors) {
    const double x = (*this)(tick, y_.low).x();
    list.items.emplace_back(DrawPolyline{{{x, 0}, {x, kHeight}}, false, 0.1, colors.grid, Mark::ground});
    write({x, -3.3}, fmt::format("{:.6g}", tick), colors.muted, Align::center);
  }
  void y_tick(double tick, const Theme& colors) {
    const double y = (*this)(x_.low, tick).y();
    list.items.emplace_back(DrawPolyline{{{0, y}, {width_, y}}, false, 0.1, colors.grid, Mark::ground});
    write({-1, y - 0.5 * kLetter}, fmt::format("{:.6g}", tick), colors.muted, Align::right);
  }

  Range x_, y_;
  double width_;
};

/// The curve as unbroken runs of points. Where there are more numbers than can be told apart, each group of neighbours
/// is drawn by its least and its largest one.
std::vector<std::vector<Vec2>> runs_of(std::span<const double> values, const Axes& field) {
  const std::size_t group = (values.size() + kMost - 1) / kMost;
  std::vector<std::vector<Vec2>> runs(1);
  for (std::size_t from = 0; from < values.size(); from += group) {
    const auto part = values.subspan(from, std::min(group, values.size() - from));
    Range range;
    for (const double value : part)
      if (plottable(value)) range.add(value);
    if (range.empty()) {
      if (!runs.back().empty()) runs.emplace_back();
      continue;
    }
    const double x = static_cast<double>(from) + 0.5 * static_cast<double>(part.size() + 1);
    runs.back().push_back(field(x, range.low));
    if (range.high > range.low) runs.back().push_back(field(x, range.high));
  }
  return runs;
}

}  // namespace

std::vector<double> round_ticks(double low, double high) {
  const double step = round_length((high - low) / 4);
  std::vector<double> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && ticks.size() < 12; ++k)
    ticks.push_back(k * step + 0.0);  // + 0.0: no minus zero
  return ticks;
}

DrawList draw_curve(std::span<const double> values, const PlotWords& words) {
  const Theme& colors = theme(Background::light);
  const Range x = widened({1, static_cast<double>(values.size())});
  Axes field(x, widened(range_of(values)), 2 * kHeight, words);
  for (std::vector<Vec2>& run : runs_of(values, field)) {
    if (run.size() == 1)
      field.list.items.emplace_back(DrawDisc{{run.front(), 0.6}, colors.path, Mark::curve});
    else if (run.size() > 1)
      field.list.items.emplace_back(DrawPolyline{std::move(run), false, 0.4, colors.path, Mark::curve});
  }
  return std::move(field.list);
}

DrawList draw_histogram(std::span<const double> values, int bins, const PlotWords& words) {
  if (bins < 0 || bins > 1000) fail("0 to 1000 bins expected, got {}", bins);
  const Range range = widened(range_of(values));
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite), plottable);
  if (bins == 0) bins = std::clamp(static_cast<int>(std::ceil(std::sqrt(finite.size()))), 1, 40);
  std::vector<double> counts(static_cast<std::size_t>(bins));
  const double width = (range.high - range.low) / bins;
  for (const double value : finite)
    ++counts[static_cast<std::size_t>(std::clamp(static_cast<int>((value - range.low) / width), 0, bins - 1))];
  const Range high{0, *std::max_element(counts.begin(), counts.end())};
  Axes field(range, high, 2 * kHeight, words);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const double left = range.low + static_cast<double>(i) * width;
    const Vec2 gap(0.05 * 2 * kHeight / bins, 0);
    field.list.items.emplace_back(DrawArea{{Axes::box(field(left, 0) + gap, field(left + width, counts[i]) - gap), {}},
                                           theme(Background::light).path,
                                           Mark::bar});
  }
  return std::move(field.list);
}

DrawList draw_heat_map(std::span<const float> values, int rows, int columns, const PlotWords& words) {
  if (rows < 1 || columns < 1 || values.size() != static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns))
    fail("a matrix with rows and columns expected, got {} x {}", rows, columns);
  const Theme& colors = theme(Background::light);
  const Range range = widened(range_of(std::vector<double>(values.begin(), values.end())));
  const double width = std::clamp(kHeight * columns / rows, kHeight, 2 * kHeight);
  PlotWords titled = words;
  titled.title += fmt::format("{}{:.4g} .. {:.4g}", words.title.empty() ? "" : ", ", range.low, range.high);
  Axes field({0.5, columns + 0.5}, {rows + 0.5, 0.5}, width, titled);
  constexpr double kCell = 0.25;
  DrawCells cells{{}, kCell, static_cast<int>(width / kCell), static_cast<int>(kHeight / kCell), {}, {}};
  const auto place = [](int i, int length, int count) {  // a long matrix times a cell does not fit an int
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(count) / static_cast<std::size_t>(length);
  };
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x) {
      const std::size_t row = static_cast<std::size_t>(rows) - 1 - place(y, cells.height, rows);
      const double value = values[row * static_cast<std::size_t>(columns) + place(x, cells.width, columns)];
      const double share = (value - range.low) / (range.high - range.low);
      const Color dark = mixed(colors.path, colors.wall, 0.7);
      cells.colors.push_back(!plottable(value) ? Color{0, 0, 0, 0}
                             : share < 0.5     ? mixed(colors.floor, colors.path, 2 * share)
                                               : mixed(colors.path, dark, 2 * share - 1));
    }
  field.list.items.emplace_back(std::move(cells));
  return std::move(field.list);
}

}  // namespace meander

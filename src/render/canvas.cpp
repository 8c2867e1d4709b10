// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "render/clip.hpp"
#include "render/unicode.hpp"

namespace meander {
namespace {

constexpr int kShift = 6;  ///< fractional bits of coordinates handed to OpenCV

/// Coverage of a rectangle of the canvas by one item.
struct Stencil {
  cv::Rect box;
  cv::Mat mask;  ///< 0 .. 255
};

/// An empty stencil over the part of the canvas that the points, grown by `margin` pixels, may touch.
Stencil stencil(const Canvas& canvas, const std::vector<std::vector<Vec2>>& runs, double margin) {
  Vec2 low(1e9, 1e9), high(-1e9, -1e9);
  for (const auto& run : runs)
    for (const Vec2& p : run) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const auto pixel = [](double at, int most) { return static_cast<int>(std::clamp<double>(at, 0, most)); };
  const int x0 = pixel(std::floor(low.x() - margin), canvas.image.width);
  const int y0 = pixel(std::floor(low.y() - margin), canvas.image.height);
  const int x1 = pixel(std::ceil(high.x() + margin) + 1, canvas.image.width);
  const int y1 = pixel(std::ceil(high.y() + margin) + 1, canvas.image.height);
  if (x1 <= x0 || y1 <= y0) return {};
  return {cv::Rect(x0, y0, x1 - x0, y1 - y0), cv::Mat::zeros(y1 - y0, x1 - x0, CV_8U)};
}

/// Picture coordinates count from the corner of the first pixel, OpenCV's from its centre.
std::vector<cv::Point> fixed_point(const std::vector<Vec2>& points, const cv::Rect& box) {
  std::vector<cv::Point> fixed;
  fixed.reserve(points.size());
  for (const Vec2& p : points)
    fixed.emplace_back(static_cast<int>(std::lround((p.x() - box.x - 0.5) * (1 << kShift))),
                       static_cast<int>(std::lround((p.y() - box.y - 0.5) * (1 << kShift))));
  return fixed;
}

std::vector<std::vector<cv::Point>> fixed_point(const std::vector<std::vector<Vec2>>& runs, const cv::Rect& box) {
  std::vector<std::vector<cv::Point>> fixed;
  for (const auto& run : runs) fixed.push_back(fixed_point(run, box));
  return fixed;
}

void blend(std::uint8_t* pixel, Color color, int alpha) {
  if (alpha == 255) {
    pixel[0] = color.r, pixel[1] = color.g, pixel[2] = color.b;
    return;
  }
  const auto mix = [&](std::uint8_t below, std::uint8_t above) {
    return static_cast<std::uint8_t>((below * (255 - alpha) + above * alpha + 127) / 255);
  };
  pixel[0] = mix(pixel[0], color.r);
  pixel[1] = mix(pixel[1], color.g);
  pixel[2] = mix(pixel[2], color.b);
}

/// Lays the colour over the canvas wherever the stencil is open.
void press(Canvas& canvas, const Stencil& stencil, Color color, Mark mark) {
  for (int row = 0; row < stencil.mask.rows; ++row) {
    const std::uint8_t* cover = stencil.mask.ptr<std::uint8_t>(row);
    auto at = static_cast<std::size_t>(stencil.box.y + row) * static_cast<std::size_t>(canvas.image.width) +
              static_cast<std::size_t>(stencil.box.x);
    for (int column = 0; column < stencil.mask.cols; ++column, ++at) {
      if (cover[column] == 0) continue;
      blend(&canvas.image.pixels[3 * at], color, (cover[column] * color.a + 127) / 255);
      if (cover[column] >= 128) canvas.marks[at] = static_cast<std::uint8_t>(mark);
    }
  }
}

/// Without smoothing, pixels of a line join along rows and columns, so that thin walls are tight.
int line_type(const Canvas& canvas) { return canvas.smooth ? cv::LINE_AA : cv::LINE_4; }

/// What can be seen, plus `margin` pixels: nothing outside reaches OpenCV, whose coordinates are 32 bits wide.
Box reach(const Canvas& canvas, double margin) {
  return {Vec2(-margin, -margin), Vec2(canvas.image.width + margin, canvas.image.height + margin)};
}

std::vector<Vec2> on_canvas(const Canvas& canvas, const std::vector<Vec2>& points) {
  std::vector<Vec2> pixels;
  pixels.reserve(points.size());
  for (const Vec2& p : points) pixels.push_back(canvas.viewport(p));
  return pixels;
}

void fill(Canvas& canvas, const std::vector<std::vector<Vec2>>& world_rings, Color color, Mark mark) {
  std::vector<std::vector<Vec2>> rings;
  for (const auto& ring : world_rings) {
    auto clipped = clipped_ring(on_canvas(canvas, ring), reach(canvas, 4));
    if (clipped.size() >= 3) rings.push_back(std::move(clipped));
  }
  Stencil area = stencil(canvas, rings, 1);
  if (area.mask.empty()) return;
  cv::fillPoly(area.mask, fixed_point(rings, area.box), cv::Scalar(255), line_type(canvas), kShift);
  press(canvas, area, color, mark);
}

void paint_item(Canvas& canvas, const DrawArea& area) {
  std::vector<std::vector<Vec2>> rings{area.polygon.outer};
  rings.insert(rings.end(), area.polygon.holes.begin(), area.polygon.holes.end());
  fill(canvas, rings, area.color, area.mark);
}

void paint_item(Canvas& canvas, const DrawPolyline& line) {
  constexpr double kThickest = 32'000;  // OpenCV's limit is 32767
  const bool faint = line.mark == Mark::ground || line.mark == Mark::grid || line.mark == Mark::open_door;
  const double least = faint ? 1 : canvas.least_width;
  const double width = std::clamp(line.width * canvas.viewport.scale, least, kThickest);
  std::vector<std::vector<Vec2>> runs;
  for (Ring& part : clipped_line(on_canvas(canvas, line.points), line.closed, reach(canvas, width + 4))) {
    if (part.closed) part.points.push_back(part.points.front());
    runs.push_back(std::move(part.points));
  }
  Stencil stroke = stencil(canvas, runs, 0.5 * width + 1);
  if (stroke.mask.empty()) return;
  cv::polylines(stroke.mask, fixed_point(runs, stroke.box), false, cv::Scalar(255),
                static_cast<int>(std::lround(width)), line_type(canvas), kShift);
  press(canvas, stroke, line.color, line.mark);
}

void paint_item(Canvas& canvas, const DrawDisc& disc) {
  // A disc smaller than a pixel still shows as one.
  const double radius = std::max(disc.disc.radius, 0.5 * canvas.least_width / canvas.viewport.scale);
  const std::vector<Vec2> rim = circle({disc.disc.center, radius}, radius * canvas.viewport.scale);
  if (disc.line > 0)
    paint_item(canvas, DrawPolyline{rim, true, disc.line, disc.color, disc.mark});
  else
    fill(canvas, {rim}, disc.color, disc.mark);
}

/// OpenCV's stroke fonts know ASCII only.
std::string ascii(const std::string& text) {
  std::string plain;
  for (const char32_t code : code_points(text)) plain += code >= 0x20 && code < 0x7F ? static_cast<char>(code) : '?';
  return plain;
}

void paint_item(Canvas& canvas, const DrawText& text) {
  constexpr double kCapital = 21;  // [pixels] height of a capital letter at scale 1
  const double capital = text.height * canvas.viewport.scale;
  if (!canvas.lettered || capital < 2 || capital > 4000) return;
  const double scale = capital / kCapital;
  const int thickness = std::max(1, static_cast<int>(std::lround(capital / 9)));
  const int rim = std::max(2, static_cast<int>(std::lround(capital / 4)));
  const std::string letters = ascii(text.text.substr(0, 400));
  const cv::Size size = cv::getTextSize(letters, cv::FONT_HERSHEY_SIMPLEX, scale, thickness, nullptr);
  const double shift = text.align == Align::left ? 0 : text.align == Align::center ? 0.5 : 1;
  const Vec2 at = canvas.viewport(text.at) - Vec2(shift * size.width, 0);
  Stencil glyphs = stencil(canvas, {{at - Vec2(0, 1.2 * capital), at + Vec2(size.width, 0.5 * capital)}}, rim + 2);
  if (glyphs.mask.empty()) return;
  const cv::Point base(static_cast<int>(std::lround(at.x())) - glyphs.box.x,
                       static_cast<int>(std::lround(at.y())) - glyphs.box.y);
  const auto write = [&](int width, Color color) {
    glyphs.mask.setTo(0);
    cv::putText(glyphs.mask, letters, base, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(255), width, line_type(canvas));
    press(canvas, glyphs, color, text.mark);
  };
  if (text.halo.a > 0) write(thickness + 2 * rim, text.halo);
  write(thickness, text.color);
}

void paint_item(Canvas& canvas, const DrawCells& cells) {
  const double wide = cells.width * cells.resolution;
  const double high = cells.height * cells.resolution;
  const Pose2& frame = cells.origin;
  const Stencil box = stencil(
      canvas,
      {on_canvas(canvas, {frame * Vec2(0, 0), frame * Vec2(wide, 0), frame * Vec2(wide, high), frame * Vec2(0, high)})},
      1);
  // Affine from pixel centres to cells: a step to the right or down is the same everywhere.
  const Pose2 cells_from_world = inverse(frame);
  const auto cell_of = [&](double x, double y) -> Vec2 {
    return cells_from_world * canvas.viewport.world({x, y}) / cells.resolution;
  };
  const Vec2 first = cell_of(box.box.x + 0.5, box.box.y + 0.5);
  const Vec2 right = cell_of(box.box.x + 1.5, box.box.y + 0.5) - first;
  const Vec2 down = cell_of(box.box.x + 0.5, box.box.y + 1.5) - first;
  for (int row = 0; row < box.box.height; ++row)
    for (int column = 0; column < box.box.width; ++column) {
      const Vec2 p = first + right * column + down * row;
      if (!(p.x() >= 0 && p.y() >= 0 && p.x() < cells.width && p.y() < cells.height)) continue;
      const auto from =
          static_cast<std::size_t>(p.y()) * static_cast<std::size_t>(cells.width) + static_cast<std::size_t>(p.x());
      const auto to = static_cast<std::size_t>(box.box.y + row) * static_cast<std::size_t>(canvas.image.width) +
                      static_cast<std::size_t>(box.box.x + column);
      const Color color = cells.colors[from];
      if (color.a == 0) continue;
      blend(&canvas.image.pixels[3 * to], color, color.a);
      canvas.marks[to] = static_cast<std::uint8_t>(cells.marks.empty() ? Mark::cell : cells.marks[from]);
    }
}

void paint_item(Canvas& canvas, const DrawBody& body) {
  if (body.disc.radius * canvas.viewport.scale < canvas.least_body)
    return paint_item(canvas, DrawDisc{body.disc, body.color, body.mark});
  for (const DrawItem& part : parts(body)) std::visit([&](const auto& thing) { paint_item(canvas, thing); }, part);
}

}  // namespace

Canvas blank_canvas(const Viewport& viewport, int width, int height, Color background) {
  Canvas canvas;
  canvas.viewport = viewport;
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  canvas.image = {width, height, 3, std::vector<std::uint8_t>(3 * count)};
  for (std::size_t i = 0; i < count; ++i) blend(&canvas.image.pixels[3 * i], background, 255);
  canvas.marks.assign(count, static_cast<std::uint8_t>(Mark::ground));
  return canvas;
}

void paint(Canvas& canvas, const DrawList& list) {
  for (const DrawItem* item : painting_order(list))
    std::visit([&](const auto& thing) { paint_item(canvas, thing); }, *item);
}

}  // namespace meander

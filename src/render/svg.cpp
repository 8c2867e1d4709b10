// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/svg.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "render/clip.hpp"
#include "render/merge_cells.hpp"
#include "render/viewport.hpp"

namespace meander {
namespace {

constexpr double kLongerSide = 1000;
constexpr double kHairline = 1;

/// Hundredths of a unit. Numbers are rounded before anything is made of them, so that relative steps add up exactly.
struct Fixed {
  long value;
  explicit Fixed(double units) : value(std::lround(units * 100)) {}
  explicit Fixed(long hundredths) : value(hundredths) {}
};

/// The shortest decimal: "12.5", ".07", "-3".
void append(std::string& out, Fixed number) {
  const long size = std::labs(number.value);
  if (number.value < 0) out += '-';
  if (size >= 100 || size == 0) fmt::format_to(std::back_inserter(out), "{}", size / 100);
  const long hundredths = size % 100;
  if (hundredths % 10 != 0)
    fmt::format_to(std::back_inserter(out), ".{:02}", hundredths);
  else if (hundredths != 0)
    fmt::format_to(std::back_inserter(out), ".{}", hundredths / 10);
}

/// "1.5 2": a sign separates too.
void append_pair(std::string& out, long x, long y) {
  append(out, Fixed(x));
  if (y >= 0) out += ' ';
  append(out, Fixed(y));
}

std::string number(double units) {
  std::string text;
  append(text, Fixed(units));
  return text;
}

/// " fill='#rrggbb'" and its opacity where it has one.
std::string paint(const char* attribute, Color color) {
  std::string text = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", attribute, color.r, color.g, color.b);
  if (color.a < 255) text += fmt::format(" {}-opacity=\"{}\"", attribute, number(color.a / 255.0));
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

class Writer {
 public:
  explicit Writer(const DrawList& list)
      : viewport_(fit(list.view, kLongerSide, kLongerSide)),
        reach_{Vec2(-viewport_.width, -viewport_.height), Vec2(2 * viewport_.width, 2 * viewport_.height)} {
    const std::string width = number(std::max(viewport_.width, 1.0)), height = number(std::max(viewport_.height, 1.0));
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "stroke-linecap=\"round\" stroke-linejoin=\"round\" fill-rule=\"evenodd\" "
        "font-family=\"system-ui,sans-serif\">\n<rect width=\"{0}\" height=\"{1}\"{2}/>\n",
        width, height, paint("fill", list.background));
  }

  std::string finish() && {
    close_lines();
    return std::move(out_) + "</svg>\n";
  }

  /// Lines of one style that follow each other (dashes, grid lines) become one path.
  void add(const DrawPolyline& line) {
    std::string path;
    for (const Ring& run : clipped_line(on_picture(line.points), line.closed, reach_)) append_run(path, run);
    if (path.empty()) return;
    const double width = std::max(line.width * viewport_.scale, kHairline);
    std::string style =
        fmt::format("\" fill=\"none\"{} stroke-width=\"{}\"/>\n", paint("stroke", line.color), number(width));
    if (style != open_style_) {
      close_lines();
      out_ += "<path d=\"";
      open_style_ = std::move(style);
    }
    out_ += path;
  }

  void add(const DrawArea& area) {
    close_lines();
    std::string path;
    append_ring(path, area.polygon.outer);
    for (const auto& hole : area.polygon.holes) append_ring(path, hole);
    if (!path.empty()) out_ += fmt::format("<path d=\"{}\"{}/>\n", path, paint("fill", area.color));
  }

  void add(const DrawDisc& disc) {
    close_lines();
    const Vec2 center = viewport_(disc.disc.center);
    const double radius = disc.disc.radius * viewport_.scale;
    if (!reach_.contains(center) || radius > 2 * kLongerSide) return add_faceted(disc);
    std::string style = paint("fill", disc.color);
    if (disc.line > 0)
      style = fmt::format(" fill=\"none\"{} stroke-width=\"{}\"", paint("stroke", disc.color),
                          number(std::max(disc.line * viewport_.scale, kHairline)));
    out_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", number(center.x()), number(center.y()),
                        number(std::max(radius, 0.5 * kHairline)), style);
  }

  void add(const DrawText& text) {
    close_lines();
    constexpr double kCapital = 0.72;  // height of a capital letter over the font size, in common sans-serif fonts
    const Vec2 at = viewport_(text.at);
    const double size = text.height * viewport_.scale / kCapital;
    if (!reach_.contains(at) || size > 2 * kLongerSide) return;
    constexpr const char* kAnchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
    const std::string halo = text.halo.a == 0 ? ""
                                              : fmt::format(" paint-order=\"stroke\"{} stroke-width=\"{}\"",
                                                            paint("stroke", text.halo), number(size * 0.3));
    out_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}{}{}>{}</text>\n", number(at.x()), number(at.y()),
                        number(size), kAnchors[static_cast<int>(text.align)], paint("fill", text.color), halo,
                        escaped(text.text));
  }

  void add(const DrawCells& cells) {
    close_lines();
    const auto groups = merged_cells(cells);
    const Vec2 corner = viewport_(cells.origin.position());
    out_ += fmt::format(
        "<g shape-rendering=\"crispEdges\" transform=\"translate({} {}) rotate({}) scale({:.9g} {:.9g})\">\n",
        number(corner.x()), number(corner.y()), number(-degrees(cells.origin.heading)),
        cells.resolution * viewport_.scale, -cells.resolution * viewport_.scale);
    for (const CellGroup& group : groups) {
      out_ += "<path d=\"";
      for (const CellBlock& b : group.blocks)
        fmt::format_to(std::back_inserter(out_), "M{} {}h{}v{}h{}z", b.x, b.y, b.width, b.height, -b.width);
      out_ += "\"" + paint("fill", group.color) + "/>\n";
    }
    out_ += "</g>\n";
  }

  void add(const DrawBody& body) {
    for (const DrawItem& part : parts(body)) std::visit([&](const auto& thing) { add(thing); }, part);
  }

 private:
  /// Discs far larger than the picture: what crosses it is cut out of a polygon.
  void add_faceted(const DrawDisc& disc) {
    const auto rim = circle(disc.disc, disc.disc.radius * viewport_.scale);
    if (disc.line > 0)
      add(DrawPolyline{rim, true, disc.line, disc.color, disc.mark});
    else
      add(DrawArea{{rim, {}}, disc.color, disc.mark});
  }

  void close_lines() {
    out_ += open_style_;
    open_style_.clear();
  }

  std::vector<Vec2> on_picture(const std::vector<Vec2>& points) const {
    std::vector<Vec2> units;
    for (const Vec2& p : points) units.push_back(viewport_(p));
    return units;
  }

  void append_ring(std::string& path, const std::vector<Vec2>& world_ring) const {
    const auto ring = clipped_ring(on_picture(world_ring), reach_);
    if (ring.size() >= 3) append_run(path, {ring, true});
  }

  /// "M10 20l5 0 0 5z": points that round to the one before are dropped.
  static void append_run(std::string& path, const Ring& run) {
    long x = Fixed(run.points.front().x()).value, y = Fixed(run.points.front().y()).value;
    path += 'M';
    append_pair(path, x, y);
    bool stepped = false;
    for (std::size_t i = 1; i < run.points.size(); ++i) {
      const long next_x = Fixed(run.points[i].x()).value, next_y = Fixed(run.points[i].y()).value;
      if (next_x == x && next_y == y) continue;
      path += !stepped ? "l" : next_x < x ? "" : " ";
      append_pair(path, next_x - x, next_y - y);
      x = next_x, y = next_y, stepped = true;
    }
    if (!stepped) path += "h0";  // a point: round line ends still show it
    if (run.closed) path += 'z';
  }

  Viewport viewport_;
  Box reach_;               ///< in units; beyond it nothing is written
  std::string open_style_;  ///< what closes the path element that is being written
  std::string out_;
};

}  // namespace

std::string svg(const DrawList& list) {
  Writer writer(list);
  for (const DrawItem* item : painting_order(list)) std::visit([&](const auto& thing) { writer.add(thing); }, *item);
  return std::move(writer).finish();
}

}  // namespace meander

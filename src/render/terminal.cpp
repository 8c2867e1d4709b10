// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/terminal.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "render/canvas.hpp"
#include "render/pool.hpp"
#include "render/theme.hpp"
#include "render/unicode.hpp"

namespace meander {
namespace {

struct Symbol {
  char sign;         ///< ' ': only a background
  const char* name;  ///< for the legend
};

/// By Mark. Cells show their lightness instead of a sign.
constexpr Symbol kSymbols[kMarks] = {
    {' ', ""},      {' ', ""},           {' ', ""},     {' ', ""},        {':', "sonar cone"}, {'o', "place"},
    {'*', "light"}, {'\'', "open door"}, {'#', "wall"}, {'+', "door"},    {'m', "mover"},      {'.', "path"},
    {'^', "echo"},  {'S', "start"},      {'G', "goal"}, {'x', "contact"}, {'@', "robot"},      {'-', ""}};

const Symbol& symbol(Mark mark) { return kSymbols[static_cast<std::size_t>(mark)]; }

/// Signs from empty to full by the distance of a colour from the background.
char ramp(Color color, Color background) {
  constexpr std::string_view kRamp = " .:-=+*%";
  const int distance =
      std::abs(color.r - background.r) + std::abs(color.g - background.g) + std::abs(color.b - background.b);
  return kRamp[std::min<std::size_t>(kRamp.size() - 1, static_cast<std::size_t>(distance) * kRamp.size() / 600)];
}

Glyph ascii_glyph(const Pool& pool, Color background) {
  const char sign = pool.mark == Mark::cell ? ramp(pool.color, background) : symbol(pool.mark).sign;
  return {static_cast<char32_t>(sign), {}, {}};
}

/// Equal halves become a blank, so that equal pictures are equal frames.
Glyph half_block(Color upper, Color lower) {
  if (upper == lower) return {' ', lower, lower};
  return {kUpperHalf, upper, lower};
}

/// [half characters] radius below which a body shows its heading by a character.
constexpr double kLeastBody = 4;

/// The character that points along the heading.
char32_t arrow(double heading, TerminalMode mode) {
  if (mode == TerminalMode::ascii) {
    constexpr char kSigns[] = {'>', '^', '<', 'v'};
    return static_cast<char32_t>(kSigns[std::lround(wrap_angle(heading) / (kPi / 2) + 4) % 4]);
  }
  constexpr char32_t kArrows[] = {U'\u2192', U'\u2197', U'\u2191', U'\u2196',
                                  U'\u2190', U'\u2199', U'\u2193', U'\u2198'};
  return kArrows[std::lround(wrap_angle(heading) / (kPi / 4) + 8) % 8];
}

/// Writes texts over a frame. A text that would touch an earlier one or cover a higher mark is left out.
class Lettering {
 public:
  Lettering(Frame& frame, std::vector<Mark> shown, const Viewport& pixels)
      : frame_(frame), pixels_(pixels), shown_(std::move(shown)), taken_(frame.glyphs.size()) {}

  void write(const DrawText& text) {
    std::u32string words = code_points(printable(text.text));
    words.resize(std::min<std::size_t>(words.size(), static_cast<std::size_t>(frame_.columns)));
    const int length = static_cast<int>(words.size());
    const Vec2 at = pixels_(text.at + Vec2(0, 0.25 * text.height));
    if (!(at.x() >= 0 && at.y() >= 0 && at.x() < pixels_.width && at.y() < pixels_.height)) return;
    const int shift = text.align == Align::left ? 0 : text.align == Align::center ? length / 2 : length;
    const int row = std::min(static_cast<int>(at.y() / 2), frame_.rows - 1);
    const int first = std::clamp(static_cast<int>(at.x()) - shift, 0, frame_.columns - length);
    if (crowded(first, length, row) || covers(text.mark, first, length, row)) return;
    for (int i = 0; i < length; ++i) put(first + i, row, words[static_cast<std::size_t>(i)], text.color);
  }

  void write(const DrawBody& body) {
    if (!body.heading || body.disc.radius * pixels_.scale >= kLeastBody) return;
    const Vec2 at = pixels_(body.disc.center);
    const Box inside{{0, 0}, {static_cast<double>(frame_.columns), 2.0 * frame_.rows}};
    if (!inside.contains(at + Vec2(0.5, 0.5)) || !inside.contains(at)) return;
    put(static_cast<int>(at.x()), static_cast<int>(at.y() / 2), arrow(*body.heading, frame_.mode), body.nose);
  }

 private:
  bool crowded(int first, int length, int row) const {
    for (int i = std::max(0, first - 1); i < std::min(frame_.columns, first + length + 1); ++i)
      if (taken_[index(i, row)]) return true;
    return false;
  }

  bool covers(Mark mark, int first, int length, int row) const {
    const auto begin = shown_.begin() + static_cast<std::ptrdiff_t>(index(first, row));
    return std::any_of(begin, begin + length, [&](Mark below) { return below > mark; });
  }

  void put(int column, int row, char32_t code, Color ink) {
    const bool known = frame_.mode == TerminalMode::ascii ? code < 0x7F : is_narrow(code);
    Glyph& glyph = frame_.at(column, row);
    glyph.paper = glyph.code == kUpperHalf ? mixed(glyph.ink, glyph.paper, 0.5) : glyph.paper;
    glyph.code = known ? code : U'?';
    glyph.ink = frame_.mode == TerminalMode::ascii ? Color{} : ink;
    taken_[index(column, row)] = true;
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_.columns) + static_cast<std::size_t>(column);
  }

  Frame& frame_;
  const Viewport& pixels_;   ///< from metres to half characters
  std::vector<Mark> shown_;  ///< highest mark in each cell
  std::vector<bool> taken_;
};

/// The list painted with kSamples x kSamples canvas pixels for each half character.
constexpr int kSamples = 4;

Canvas sampled(const DrawList& list, const Frame& frame, Viewport pixels) {
  pixels.scale *= kSamples;
  Canvas canvas = blank_canvas(pixels, frame.columns * kSamples, frame.rows * 2 * kSamples, list.background);
  canvas.smooth = false;
  canvas.lettered = false;
  canvas.least_body = kLeastBody * kSamples;
  canvas.least_width = frame.mode == TerminalMode::ascii ? 2 : kSamples;
  paint(canvas, list);
  return canvas;
}

/// Fills in the glyphs and returns the highest mark in each.
std::vector<Mark> fill_ascii(Frame& frame, const Canvas& canvas, Color background) {
  const auto pools = pooled(canvas, kSamples, 2 * kSamples);
  std::vector<Mark> shown;
  for (std::size_t i = 0; i < pools.size(); ++i) {
    frame.glyphs[i] = ascii_glyph(pools[i], background);
    shown.push_back(pools[i].mark);
  }
  return shown;
}

std::vector<Mark> fill_half_blocks(Frame& frame, const Canvas& canvas) {
  const auto pools = pooled(canvas, kSamples, kSamples);
  const auto columns = static_cast<std::size_t>(frame.columns);
  std::vector<Mark> shown;
  for (std::size_t i = 0; i < frame.glyphs.size(); ++i) {
    const std::size_t upper = 2 * (i / columns) * columns + i % columns;
    frame.glyphs[i] = half_block(pools[upper].color, pools[upper + columns].color);
    shown.push_back(std::max(pools[upper].mark, pools[upper + columns].mark));
  }
  return shown;
}

}  // namespace

Frame terminal_frame(const DrawList& list, const TerminalSize& size, TerminalMode mode) {
  validate(size);
  const Viewport pixels = fit(list.view, size.columns, 2 * size.rows);
  Frame frame;
  frame.mode = mode;
  frame.columns = std::clamp(static_cast<int>(std::ceil(pixels.width - 1e-6)), 1, size.columns);
  frame.rows = std::clamp(static_cast<int>(std::ceil(0.5 * pixels.height - 1e-6)), 1, size.rows);
  frame.glyphs.resize(static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows));
  const Canvas canvas = sampled(list, frame, pixels);
  const bool plain = mode == TerminalMode::ascii;
  Lettering lettering(frame, plain ? fill_ascii(frame, canvas, list.background) : fill_half_blocks(frame, canvas),
                      pixels);
  for (const DrawItem* item : painting_order(list)) {
    if (const DrawText* text = std::get_if<DrawText>(item)) lettering.write(*text);
    if (const DrawBody* body = std::get_if<DrawBody>(item)) lettering.write(*body);
  }
  return frame;
}

DrawList draw_image(const Image& image) {
  DrawCells cells{{}, 1, image.width, image.height, {}, {}};
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto row_bytes = static_cast<std::size_t>(image.width) * channels;
  if (image.pixels.size() != row_bytes * static_cast<std::size_t>(image.height) || channels < 1 || channels == 2 ||
      channels > 4)
    fail("draw_image: 1, 3 or 4 channels and width x height pixels expected, got {} channels and {} bytes",
         image.channels, image.pixels.size());
  for (int row = image.height - 1; row >= 0; --row)
    for (int column = 0; column < image.width; ++column) {
      const std::uint8_t* p =
          &image.pixels[static_cast<std::size_t>(row) * row_bytes + static_cast<std::size_t>(column) * channels];
      cells.colors.push_back(channels == 1 ? Color{p[0], p[0], p[0]}
                                           : Color{p[0], p[1], p[2], channels == 4 ? p[3] : std::uint8_t{255}});
    }
  DrawList list;
  list.view = {{0, 0}, {static_cast<double>(image.width), static_cast<double>(image.height)}};
  list.items.push_back(std::move(cells));
  return list;
}

std::string legend(const DrawList& list) {
  std::set<Mark> marks;
  for (const DrawItem* item : painting_order(list)) {
    if (const DrawCells* cells = std::get_if<DrawCells>(item))
      marks.insert(cells->marks.begin(), cells->marks.end());
    else
      marks.insert(mark_of(*item));
  }
  std::string line;
  for (const Mark mark : marks)
    if (*symbol(mark).name)
      line += fmt::format("{}{} {}", line.empty() ? "" : "   ", symbol(mark).sign, symbol(mark).name);
  return line;
}

}  // namespace meander

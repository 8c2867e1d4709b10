// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/terminal.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "render/canvas.hpp"
#include "render/lettering.hpp"
#include "render/pool.hpp"

namespace meander {
namespace {

struct Symbol {
  char sign;         ///< ' ': only a background
  const char* name;  ///< for the legend
};

/// By Mark. Cells show their lightness instead of a sign.
constexpr Symbol kSymbols[kMarks] = {{' ', ""},           {' ', ""},           {' ', ""},      {'#', ""},
                                     {' ', ""},           {':', "sonar cone"}, {'o', "place"}, {'*', "light"},
                                     {'\'', "open door"}, {'#', "wall"},       {'+', "door"},  {'m', "mover"},
                                     {'.', "path"},       {'*', ""},           {'^', "echo"},  {'S', "start"},
                                     {'G', "goal"},       {'x', "contact"},    {'-', ""},      {'@', "robot"}};

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

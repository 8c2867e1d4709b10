// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/lettering.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "render/theme.hpp"
#include "render/unicode.hpp"

namespace meander {
namespace {

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

}  // namespace

Lettering::Lettering(Frame& frame, std::vector<Mark> shown, const Viewport& pixels)
    : frame_(frame), pixels_(pixels), shown_(std::move(shown)), taken_(frame.glyphs.size()) {}

void Lettering::write(const DrawText& text) {
  std::u32string words = code_points(printable(text.text));
  words.resize(std::min<std::size_t>(words.size(), static_cast<std::size_t>(frame_.columns)));
  const int length = static_cast<int>(words.size());
  const Vec2 at = pixels_(text.at + Vec2(0, 0.25 * text.height));
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < pixels_.width && at.y() < pixels_.height)) return;
  const int shift = text.align == Align::left ? 0 : text.align == Align::center ? length / 2 : length;
  const int row = std::min(static_cast<int>(at.y() / 2), frame_.rows - 1);
  const int first = std::clamp(static_cast<int>(at.x()) - shift, 0, frame_.columns - length);
  const auto line = free_line(text.mark, first, length, row);
  if (!line) return;
  for (int i = 0; i < length; ++i) put(first + i, *line, words[static_cast<std::size_t>(i)], text.color, text.halo);
}

void Lettering::write(const DrawBody& body) {
  if (!body.heading || body.disc.radius * pixels_.scale >= kLeastBody) return;
  const Vec2 at = pixels_(body.disc.center);
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < frame_.columns && at.y() < 2 * frame_.rows)) return;
  put(static_cast<int>(at.x()), static_cast<int>(at.y() / 2), arrow(*body.heading, frame_.mode), body.nose, body.color);
}

/// Names give way to what they would hide (the gap of a door above all) by a line, if there is room. Texts that belong
/// to a mark, like the numbers of goals, stay where they are.
std::optional<int> Lettering::free_line(Mark mark, int first, int length, int row) const {
  if (mark == Mark::label)
    for (const int line : {row, row - 1, row + 1})
      if (line >= 0 && line < frame_.rows && !crowded(first, length, line) && !covers(Mark::light, first, length, line))
        return line;
  if (crowded(first, length, row) || covers(mark, first, length, row)) return std::nullopt;
  return row;
}

bool Lettering::crowded(int first, int length, int row) const {
  for (int i = std::max(0, first - 1); i < std::min(frame_.columns, first + length + 1); ++i)
    if (taken_[index(i, row)]) return true;
  return false;
}

/// Is any mark above `mark` shown there?
bool Lettering::covers(Mark mark, int first, int length, int row) const {
  const auto begin = shown_.begin() + static_cast<std::ptrdiff_t>(index(first, row));
  return std::any_of(begin, begin + length, [&](Mark below) { return below > mark; });
}

/// The halo of a text becomes the paper it stands on, as far as it is opaque: dark letters stay readable on dark walls.
void Lettering::put(int column, int row, char32_t code, Color ink, Color halo) {
  const bool plain = frame_.mode == TerminalMode::ascii;
  const bool known = plain ? code < 0x7F : is_narrow(code);
  Glyph& glyph = frame_.at(column, row);
  const Color below = glyph.code == kUpperHalf ? mixed(glyph.ink, glyph.paper, 0.5) : glyph.paper;
  glyph.code = known ? code : U'?';
  if (!plain) glyph.ink = ink, glyph.paper = mixed(below, faded(halo, 255), halo.a / 255.0);
  taken_[index(column, row)] = true;
}

std::size_t Lettering::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_.columns) + static_cast<std::size_t>(column);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/sixel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <vector>

#include "base/error.hpp"

namespace meander {
namespace {

constexpr int kBand = 6;  ///< rows of pixels in one row of sixels
constexpr std::size_t kMostColors = 256;

using Rgb = std::array<int, 3>;

/// An image whose pixels are numbers of colours.
struct Indexed {
  std::vector<Rgb> palette;
  std::vector<std::uint8_t> pixels;
};

/// Pixels whose channels agree in their upper bits.
struct Bin {
  std::int64_t count = 0;
  std::array<std::int64_t, 3> sum{};
  std::uint8_t number = 0;  ///< in the palette
};

std::size_t bin_of(const std::uint8_t* rgb, int bits) {
  const auto upper = [&](std::size_t i) { return static_cast<std::size_t>(rgb[i] >> (8 - bits)); };
  return (upper(0) << bits | upper(1)) << bits | upper(2);
}

std::vector<Bin> binned(const Image& image, int bits) {
  std::vector<Bin> bins(std::size_t{1} << (3 * bits));
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
    Bin& bin = bins[bin_of(&image.pixels[i], bits)];
    ++bin.count;
    for (std::size_t k = 0; k < 3; ++k) bin.sum[k] += image.pixels[i + k];
  }
  return bins;
}

std::size_t used(const std::vector<Bin>& bins) {
  return static_cast<std::size_t>(std::count_if(bins.begin(), bins.end(), [](const Bin& b) { return b.count > 0; }));
}

/// Alike colours become their mean, as finely as the palette allows.
Indexed indexed(const Image& image) {
  int bits = 6;
  std::vector<Bin> bins = binned(image, bits);
  while (used(bins) > kMostColors) bins = binned(image, --bits);
  Indexed result;
  for (Bin& bin : bins) {
    if (bin.count == 0) continue;
    bin.number = static_cast<std::uint8_t>(result.palette.size());
    Rgb& mean = result.palette.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<int>((bin.sum[k] + bin.count / 2) / bin.count);
  }
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3)
    result.pixels.push_back(bins[bin_of(&image.pixels[i], bits)].number);
  return result;
}

/// Six pixels of a column become one character; four or more alike become "!count character".
void append_run(std::string& out, int count, char sign) {
  if (count > 3)
    fmt::format_to(std::back_inserter(out), "!{}{}", count, sign);
  else
    out.append(static_cast<std::size_t>(count), sign);
}

/// One colour in a band: its columns from the first to the last that has it.
void append_color(std::string& out, std::size_t color, const std::vector<std::uint8_t>& bits) {
  fmt::format_to(std::back_inserter(out), "#{}", color);
  std::size_t end = bits.size();
  while (end > 0 && bits[end - 1] == 0) --end;
  for (std::size_t from = 0, to = 0; from < end; from = to) {
    while (to < end && bits[to] == bits[from]) ++to;
    append_run(out, static_cast<int>(to - from), static_cast<char>('?' + bits[from]));
  }
  out += '$';
}

void append_band(std::string& out, const Indexed& image, int width, int top, int bottom) {
  std::array<bool, kMostColors> present{};
  const auto pixel = [&](int x, int y) {
    return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  };
  for (int y = top; y < bottom; ++y)
    for (int x = 0; x < width; ++x) present[pixel(x, y)] = true;
  std::vector<std::uint8_t> bits(static_cast<std::size_t>(width));
  for (std::size_t color = 0; color < image.palette.size(); ++color) {
    if (!present[color]) continue;
    std::fill(bits.begin(), bits.end(), std::uint8_t{0});
    for (int y = top; y < bottom; ++y)
      for (int x = 0; x < width; ++x)
        if (pixel(x, y) == color) bits[static_cast<std::size_t>(x)] |= static_cast<std::uint8_t>(1 << (y - top));
    append_color(out, color, bits);
  }
  out += '-';
}

}  // namespace

std::string sixel_picture(const Image& image) {
  if (image.channels != 3) fail("sixel: an RGB image expected, got {} channels", image.channels);
  const Indexed colors = indexed(image);
  std::string out = fmt::format("\x1bP0;1;0q\"1;1;{};{}", image.width, image.height);
  const auto percent = [](int value) { return (value * 100 + 127) / 255; };
  for (std::size_t i = 0; i < colors.palette.size(); ++i) {
    const auto& [r, g, b] = colors.palette[i];
    fmt::format_to(std::back_inserter(out), "#{};2;{};{};{}", i, percent(r), percent(g), percent(b));
  }
  for (int top = 0; top < image.height; top += kBand)
    append_band(out, colors, image.width, top, std::min(top + kBand, image.height));
  return out + "\x1b\\\n";
}

}  // namespace meander

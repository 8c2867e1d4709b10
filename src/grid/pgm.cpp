// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/pgm.hpp"

#include <fmt/format.h>

#include <string_view>

#include "base/error.hpp"

namespace meander {
namespace {

bool is_space(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class PgmReader {
 public:
  PgmReader(std::span<const std::uint8_t> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Image read() {
    const bool binary = bytes_[1] == '5';
    Image image;
    image.width = number("width", kMaxPixels);
    image.height = number("height", kMaxPixels);
    maxval_ = number("maxval", 65535);
    const std::int64_t count = std::int64_t{image.width} * image.height;
    if (count == 0 || maxval_ == 0)
      fail<FileError>("{}: width, height and maxval >= 1 expected, got {} x {}, {}", name_, image.width, image.height,
                      maxval_);
    if (count > kMaxPixels)
      fail<FileError>("{}: {} x {} pixels, at most {} are read", name_, image.width, image.height, kMaxPixels);
    if (binary && (at_ == bytes_.size() || !is_space(bytes_[at_++])))
      fail<FileError>("{}: one blank expected after maxval", name_);
    // A binary pixel takes one or two bytes, a written one a digit and (but for the last) a blank.
    const std::int64_t least = binary ? count * (maxval_ > 255 ? 2 : 1) : 2 * count - 1;
    if (static_cast<std::int64_t>(bytes_.size() - at_) < least)
      fail<FileError>("{}: cut short: {} x {} pixels need {} bytes, {} are there", name_, image.width, image.height,
                      least, bytes_.size() - at_);
    image.pixels.resize(static_cast<std::size_t>(count));
    for (std::uint8_t& pixel : image.pixels) pixel = scaled(binary ? sample() : number("grey value", maxval_));
    return image;
  }

 private:
  /// Blanks, and comments from '#' to the end of the line.
  void skip_blanks() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#')
        while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
      else
        ++at_;
    }
  }

  int number(const char* what, std::int64_t most) {
    skip_blanks();
    const std::size_t first = at_;
    std::int64_t value = 0;
    while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9' && value <= most)
      value = 10 * value + (bytes_[at_++] - '0');
    if (at_ == first)
      fail<FileError>("{}: byte {}: {} expected, got {}", name_, at_ + 1, what,
                      at_ == bytes_.size() ? "the end of the file" : "something else");
    if (value > most) fail<FileError>("{}: byte {}: {} up to {} expected, got more", name_, first + 1, what, most);
    return static_cast<int>(value);
  }

  /// Big-endian where a value takes two bytes.
  int sample() {
    int value = bytes_[at_++];
    if (maxval_ > 255) value = 256 * value + bytes_[at_++];
    return std::min(value, maxval_);
  }

  std::uint8_t scaled(int value) const {
    return static_cast<std::uint8_t>(maxval_ == 255 ? value : (value * 255 + maxval_ / 2) / maxval_);
  }

  std::span<const std::uint8_t> bytes_;
  const std::string& name_;
  std::size_t at_ = 2;
  int maxval_ = 255;
};

}  // namespace

bool is_pgm(std::span<const std::uint8_t> bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5') &&
         (is_space(bytes[2]) || bytes[2] == '#');
}

Image pgm_image(std::span<const std::uint8_t> bytes, const std::string& name) { return PgmReader(bytes, name).read(); }

std::string pgm_text(const Image& image) {
  std::string text = fmt::format("P5\n{} {}\n255\n", image.width, image.height);
  text.append(image.pixels.begin(), image.pixels.end());
  return text;
}

}  // namespace meander

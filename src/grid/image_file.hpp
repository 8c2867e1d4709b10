// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace meander {

/// 8-bit image, rows from the top, channels interleaved: 1 grey, 3 RGB, 4 RGBA.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 1;
  std::vector<std::uint8_t> pixels;
  bool operator==(const Image&) const = default;
};

/// Largest image that is read: width x height.
inline constexpr std::int64_t kMaxPixels = 100'000'000;

/// Reads PGM (P2, P5, any maxval, comments) itself, everything else (PNG, JPEG, BMP, TIFF) by OpenCV's codecs, which
/// are loaded at the first use because they cost 60 ms at start-up. Throws FileError (missing, not an image, cut short,
/// larger than kMaxPixels: judged by the header before memory is taken).
Image read_image(const std::string& path);

/// The same from memory; `name` starts the messages.
Image image_from_bytes(std::span<const std::uint8_t> bytes, const std::string& name);

/// Writes by suffix: .png, .pgm (grey only). Atomic: temporary file, fsync, rename. Throws FileError.
void write_image(const std::string& path, const Image& image);

/// The bytes of a PNG file; `name` starts the messages.
std::string png_bytes(const Image& image, const std::string& name);

/// Brightness of a pixel, (0, 0) at the top left: the mean of its colours, without alpha.
std::uint8_t grey(const Image& image, int x, int y);

}  // namespace meander

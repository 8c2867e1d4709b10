// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/image_header.hpp"

#include <cstdlib>
#include <string_view>

namespace meander {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Unsigned number of `size` bytes; 0 beyond the end.
std::int64_t big_endian(Bytes bytes, std::size_t at, std::size_t size) {
  if (at + size > bytes.size()) return 0;
  std::int64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = 256 * value + bytes[at + i];
  return value;
}

std::int64_t little_endian(Bytes bytes, std::size_t at, std::size_t size) {
  if (at + size > bytes.size()) return 0;
  std::int64_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = 256 * value + bytes[at + i];
  return value;
}

bool starts_with(Bytes bytes, std::string_view mark, std::size_t at = 0) {
  return bytes.size() >= at + mark.size() &&
         std::string_view(reinterpret_cast<const char*>(bytes.data()) + at, mark.size()) == mark;
}

/// Chunks of length, type, data and checksum from IHDR to IEND.
ImageHeader png_header(Bytes bytes) {
  ImageHeader header{"PNG"};
  if (starts_with(bytes, "IHDR", 12)) {
    header.width = big_endian(bytes, 16, 4);
    header.height = big_endian(bytes, 20, 4);
  }
  std::size_t at = 8;
  while (at + 12 <= bytes.size() && !starts_with(bytes, "IEND", at + 4))
    at += 12 + static_cast<std::size_t>(big_endian(bytes, at, 4));
  header.complete = at + 12 <= bytes.size();
  return header;
}

/// Segments up to the first frame (SOF) tell the size; the picture ends with FF D9.
ImageHeader jpeg_header(Bytes bytes) {
  ImageHeader header{"JPEG"};
  std::size_t at = 2;
  while (at + 9 <= bytes.size() && bytes[at] == 0xff) {
    const int marker = bytes[at + 1];
    if (marker == 0xff) {
      ++at;  // fill byte
      continue;
    }
    const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) {
      header.height = big_endian(bytes, at + 5, 2);
      header.width = big_endian(bytes, at + 7, 2);
      break;
    }
    at += 2 + static_cast<std::size_t>(big_endian(bytes, at + 2, 2));
  }
  header.complete = false;
  for (std::size_t i = bytes.size(); i-- > at + 1 && !header.complete;)
    header.complete = bytes[i] == 0xd9 && bytes[i - 1] == 0xff;
  return header;
}

/// Windows bitmaps; a negative height means rows from the top.
ImageHeader bmp_header(Bytes bytes) {
  const auto size = [&](std::size_t at) {
    return std::abs(static_cast<std::int64_t>(static_cast<std::int32_t>(little_endian(bytes, at, 4))));
  };
  return {"BMP", size(18), size(22), true};
}

/// Tags 256 and 257 of the first directory.
ImageHeader tiff_header(Bytes bytes) {
  const auto number = starts_with(bytes, "II") ? little_endian : big_endian;
  ImageHeader header{"TIFF"};
  const auto directory = static_cast<std::size_t>(number(bytes, 4, 4));
  const std::int64_t count = number(bytes, directory, 2);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::size_t entry = directory + 2 + 12 * static_cast<std::size_t>(i);
    const std::int64_t tag = number(bytes, entry, 2);
    const bool is_short = number(bytes, entry + 2, 2) == 3;
    if (tag == 256) header.width = number(bytes, entry + 8, is_short ? 2 : 4);
    if (tag == 257) header.height = number(bytes, entry + 8, is_short ? 2 : 4);
  }
  return header;
}

}  // namespace

std::optional<ImageHeader> image_header(Bytes bytes) {
  using namespace std::string_view_literals;
  if (starts_with(bytes, "\x89PNG\r\n\x1a\n")) return png_header(bytes);
  if (starts_with(bytes, "\xff\xd8\xff")) return jpeg_header(bytes);
  if (starts_with(bytes, "BM")) return bmp_header(bytes);
  if (starts_with(bytes, "II*\0"sv) || starts_with(bytes, "MM\0*"sv)) return tiff_header(bytes);
  return std::nullopt;
}

}  // namespace meander

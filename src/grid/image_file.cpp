// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/image_file.hpp"

#include <filesystem>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/text_file.hpp"
#include "grid/image_codec.hpp"
#include "grid/image_header.hpp"
#include "grid/pgm.hpp"

namespace meander {
namespace {

/// No image of kMaxPixels needs more, so a larger file is none of ours.
constexpr std::size_t kMaxFileSize = 8 * static_cast<std::size_t>(kMaxPixels);

void check(const ImageHeader& header, const std::string& name) {
  if (header.width <= 0 || header.height <= 0) fail<FileError>("{}: {} without a size", name, header.kind);
  if (header.width > kMaxPixels || header.height > kMaxPixels || header.width * header.height > kMaxPixels)
    fail<FileError>("{}: {} x {} pixels, at most {} are read", name, header.width, header.height, kMaxPixels);
  if (!header.complete) fail<FileError>("{}: cut short: the end of the {} is missing", name, header.kind);
}

void check(const Image& image, const std::string& path) {
  const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const bool kind = image.channels == 1 || image.channels == 3 || image.channels == 4;
  if (image.width < 1 || image.height < 1 || !kind ||
      image.pixels.size() != count * static_cast<std::size_t>(image.channels))
    fail("{}: an image with pixels of 1, 3 or 4 channels expected, got {} x {} x {} and {} values", path, image.width,
         image.height, image.channels, image.pixels.size());
}

}  // namespace

std::string png_bytes(const Image& image, const std::string& path) {
  check(image, path);
  std::vector<std::uint8_t> bytes;
  const std::string complaint = image_codec().encode_png(image, bytes);
  if (!complaint.empty()) fail<FileError>("{}: cannot be written as PNG: {}", path, complaint);
  return {bytes.begin(), bytes.end()};
}

Image image_from_bytes(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (is_pgm(bytes)) return pgm_image(bytes, name);
  const auto header = image_header(bytes);
  if (!header) fail<FileError>("{}: a PGM, PNG, JPEG, BMP or TIFF image expected, got something else", name);
  check(*header, name);
  Image image;
  const std::string complaint = image_codec().decode(bytes, image);
  if (!complaint.empty()) fail<FileError>("{}: cannot be read as {}: {}", name, header->kind, complaint);
  return image;
}

Image read_image(const std::string& path) {
  const std::string text = read_text_file(path, kMaxFileSize);
  return image_from_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, path);
}

void write_image(const std::string& path, const Image& image) {
  check(image, path);
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (suffix == ".pgm" && image.channels != 1)
    fail("{}: a grey image expected for PGM, got {} channels", path, image.channels);
  if (suffix == ".pgm") return write_file_atomically(path, pgm_text(image));
  if (suffix == ".png") return write_file_atomically(path, png_bytes(image, path));
  fail("{}: images are written as .png or .pgm, got '{}'", path, suffix);
}

std::uint8_t grey(const Image& image, int x, int y) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::uint8_t* pixel =
      &image
           .pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
                   channels];
  return image.channels == 1 ? pixel[0] : static_cast<std::uint8_t>((pixel[0] + pixel[1] + pixel[2] + 1) / 3);
}

}  // namespace meander

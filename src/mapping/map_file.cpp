// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/map_file.hpp"

#include <cmath>
#include <filesystem>

#include "base/atomic_file.hpp"
#include "grid/image_file.hpp"

namespace meander {
namespace {

constexpr float kOccupiedFrom = 0.65F, kFreeUpTo = 0.196F;
constexpr std::uint8_t kOccupied = 0, kFree = 254, kUnknown = 205;

std::uint8_t three_shades(float p) { return p >= kOccupiedFrom ? kOccupied : p <= kFreeUpTo ? kFree : kUnknown; }
std::uint8_t all_shades(float p) { return static_cast<std::uint8_t>(std::lround(255 * (1 - p))); }

template <class Shade>
Image map_image(const Grid<float>& probability, Shade shade) {
  Image image{probability.width(), probability.height(), 1, {}};
  image.pixels.reserve(probability.cells().size());
  for (int y = probability.height() - 1; y >= 0; --y)
    for (int x = 0; x < probability.width(); ++x) image.pixels.push_back(shade(probability[{x, y}]));
  return image;
}

/// A YAML text in double quotes.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

void save_ros_map(const Grid<float>& probability, const std::filesystem::path& yaml) {
  const std::filesystem::path image = std::filesystem::path(yaml).replace_extension(".pgm");
  write_image(image.string(), map_image(probability, three_shades));
  const Pose2& origin = probability.frame.origin;
  write_file_atomically(
      yaml.string(),
      fmt::format("image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, {}]\nnegate: 0\noccupied_thresh: 0.65\n"
                  "free_thresh: 0.196\n",
                  quoted(image.filename().string()), probability.frame.resolution, origin.x, origin.y, origin.heading));
}

}  // namespace

void save_map(const Grid<float>& probability, const std::string& path) {
  if (probability.cells().empty()) fail("{}: the map is empty, nothing was written", path);
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (suffix == ".yaml" || suffix == ".yml")
    save_ros_map(probability, path);
  else if (suffix == ".pgm" || suffix == ".png")
    write_image(path, map_image(probability, all_shades));
  else
    fail<FileError>("{}: a name with the suffix .yaml, .yml, .pgm or .png expected", path);
}

}  // namespace meander

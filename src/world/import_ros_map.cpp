// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_ros_map.hpp"

#include <cmath>
#include <filesystem>

#include "base/text_file.hpp"
#include "world/import_raster.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

constexpr std::size_t kLargestYaml = 1 << 20;  // [bytes]
/// What map savers write for unknown cells; p = (255 - 205) / 255 = 0.19608.
constexpr int kUnknownGrey = 205;
constexpr double kUnknownShare = (255 - kUnknownGrey) / 255.0;

struct Pixel {
  double brightness;  ///< [0, 255]
  bool opaque;
};

Pixel pixel_at(const Image& image, int x, int y, const RosMapFile& file, RosConvention convention) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  const std::uint8_t* values = &image.pixels[at * channels];
  if (channels < 4) return {static_cast<double>(grey(image, x, y)), true};
  const bool average_alpha = convention == RosConvention::ros1 && file.mode == RosMapMode::trinary;
  const double brightness = average_alpha ? (values[0] + values[1] + values[2] + values[3]) / 4.0 : grey(image, x, y);
  return {brightness, average_alpha || values[3] == 255};
}

int occupancy(const RosMapFile& file, const Pixel& pixel, RosConvention convention) {
  if (file.mode == RosMapMode::raw) {
    const int value = static_cast<int>(std::lround(pixel.brightness));
    return value <= 100 ? value : -1;
  }
  const bool strict = convention == RosConvention::ros1;
  if (!pixel.opaque && !strict) return -1;
  const double p = (file.negate ? pixel.brightness : 255 - pixel.brightness) / 255;
  if (strict ? p > file.occupied_thresh : p >= file.occupied_thresh) return 100;
  if (strict ? p < file.free_thresh : p <= file.free_thresh) return 0;
  if (file.mode == RosMapMode::trinary || !pixel.opaque) return -1;
  const double share = (p - file.free_thresh) / (file.occupied_thresh - file.free_thresh);
  return static_cast<int>(strict ? 1 + 98 * share : std::lround(100 * share));
}

struct Counts {
  std::int64_t free = 0, occupied = 0, unknown = 0;
  std::int64_t rescued = 0;  ///< of the unknown: would have been free by the thresholds
};

bool is_unknown_grey(const Image& image, int x, int y) { return grey(image, x, y) == kUnknownGrey; }

Grid<std::uint8_t> solid_cells(const RosMapFile& file, const Image& image, const RosMapOptions& options,
                               Counts& counts) {
  const Grid<std::int8_t> occupied = ros_occupancy(file, image, options.convention);
  Grid<std::uint8_t> solid(image.width, image.height, 0, occupied.frame);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      int value = occupied[{x, y}];
      if (value == 0 && file.mode == RosMapMode::trinary && is_unknown_grey(image, x, image.height - 1 - y)) {
        value = -1;
        ++counts.rescued;
      }
      ++(value < 0 ? counts.unknown : value >= 50 ? counts.occupied : counts.free);
      solid[{x, y}] = value < 0 ? options.unknown != Unknown::free : value >= 50;
    }
  return solid;
}

void report_counts(const Counts& counts, const RosMapFile& file, const RosMapOptions& options,
                   std::vector<std::string>& report) {
  report.push_back(fmt::format("{} cells free, {} occupied, {} unknown{}", counts.free, counts.occupied, counts.unknown,
                               counts.unknown == 0                ? ""
                               : options.unknown == Unknown::free ? ", taken as free"
                                                                  : ", taken as solid"));
  if (counts.rescued > 0 && options.unknown == Unknown::automatic)
    report.push_back(fmt::format(
        "warning: free_thresh {} is {} {:.5f}, the value of grey {}: by the file alone the {} cells of that grey, "
        "which "
        "map savers write for unknown, would be free; they are taken as unknown (unknown = \"free\" drives there)",
        file.free_thresh, file.free_thresh > kUnknownShare ? "above" : "at", kUnknownShare, kUnknownGrey,
        counts.rescued));
}

}  // namespace

Grid<std::int8_t> ros_occupancy(const RosMapFile& file, const Image& image, RosConvention convention) {
  Grid<std::int8_t> grid(image.width, image.height, 0, {file.resolution, file.origin});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      grid[{x, y}] = static_cast<std::int8_t>(
          occupancy(file, pixel_at(image, x, image.height - 1 - y, file, convention), convention));
  return grid;
}

Imported import_ros_map(const std::string& yaml_path, const RosMapOptions& options, const Work& work) {
  validate(options.trace);
  const RosMapFile file = ros_map_file(read_text_file(yaml_path, kLargestYaml), yaml_path);
  const std::filesystem::path folder = std::filesystem::path(yaml_path).parent_path();
  const std::string image_path = (folder / file.image).string();
  if (options.opens) options.opens(image_path);
  const Image image = read_image(image_path);
  Counts counts;
  const Grid<std::uint8_t> solid = solid_cells(file, image, options, counts);
  std::vector<std::string> report{fmt::format("{}: {}", printable(file.image), size_text(solid))};
  report.insert(report.end(), file.notes.begin(), file.notes.end());
  report_counts(counts, file, options, report);
  return world_from_raster(solid, yaml_path, options.trace, std::move(report), work);
}

}  // namespace meander

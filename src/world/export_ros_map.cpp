// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/export_ros_map.hpp"

#include <filesystem>

#include "base/atomic_file.hpp"
#include "grid/image_file.hpp"
#include "world/import_yaml.hpp"
#include "world/rasterize.hpp"

namespace meander {
namespace {

constexpr std::uint8_t kOccupied = 0, kFree = 254;

Image map_image(const Grid<std::uint8_t>& grid) {
  Image image{grid.width(), grid.height(), 1, {}};
  image.pixels.reserve(grid.cells().size());
  for (int y = grid.height() - 1; y >= 0; --y)
    for (int x = 0; x < grid.width(); ++x) image.pixels.push_back(grid[{x, y}] ? kOccupied : kFree);
  return image;
}

}  // namespace

void export_ros_map(const World& world, const std::string& yaml_path, double resolution, const Work& work) {
  const std::filesystem::path path(yaml_path);
  if (path.extension() != ".yaml" && path.extension() != ".yml")
    fail<FileError>("{}: a name with the suffix .yaml or .yml expected", yaml_path);
  const std::filesystem::path image_path = std::filesystem::path(path).replace_extension(".pgm");
  const Grid<std::uint8_t> grid = rasterize(world, resolution, world.header().bounds, work);
  write_image(image_path.string(), map_image(grid));
  const Pose2& origin = grid.frame.origin;
  write_file_atomically(yaml_path,
                        fmt::format("image: {}\n"
                                    "mode: trinary\n"
                                    "resolution: {}\n"
                                    "origin: [{}, {}, 0]\n"
                                    "negate: 0\n"
                                    "occupied_thresh: 0.65\n"
                                    "free_thresh: 0.196\n",
                                    yaml_scalar(image_path.filename().string()), resolution, origin.x, origin.y));
}

}  // namespace meander

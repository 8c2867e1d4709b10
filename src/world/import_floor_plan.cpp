// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_floor_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "grid/image_file.hpp"
#include "world/import_raster.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

constexpr int kRosUnknown = 205;

/// Brightness on white paper.
Grid<std::uint8_t> brightness(const Image& image, double resolution, const Work& work) {
  Grid<std::uint8_t> grid(image.width, image.height, 0, {resolution, {}});
  for (int y = 0; y < image.height; ++y) {
    work.poll();
    const int row = image.height - 1 - y;
    for (int x = 0; x < image.width; ++x) {
      int value = grey(image, x, row);
      if (image.channels == 4) {
        const auto at =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
        const int alpha = image.pixels[4 * at + 3];
        value = 255 - (255 - value) * alpha / 255;
      }
      grid[{x, y}] = static_cast<std::uint8_t>(value);
    }
  }
  return grid;
}

/// The grey that separates dark and light best (Otsu 1979): light from it on.
double otsu_threshold(const Grid<std::uint8_t>& grid) {
  const cv::Mat in(grid.height(), grid.width(), CV_8U, const_cast<std::uint8_t*>(grid.cells().data()));
  cv::Mat ignored;
  return cv::threshold(in, ignored, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU) + 1;
}

}  // namespace

Imported import_floor_plan(const std::string& image_path, const FloorPlanOptions& options, const Work& work) {
  validate(options);
  Grid<std::uint8_t> grid = brightness(read_image(image_path), options.resolution, work);
  const double threshold = options.threshold > 0 ? options.threshold : otsu_threshold(grid);
  work.poll();
  const std::vector<std::uint8_t> greys = grid.cells();
  for (auto& cell : grid.cells()) cell = (cell < threshold) != options.negate;
  const auto solid = std::count(grid.cells().begin(), grid.cells().end(), 1);
  const double share = static_cast<double>(solid) / static_cast<double>(grid.cells().size());
  std::vector<std::string> report{
      fmt::format("{}: {}", printable(std::filesystem::path(image_path).filename().string()), size_text(grid)),
      fmt::format("{:.1f} % of the pixels are walls: {} than grey {:g}{}", 100 * share,
                  options.negate ? "not darker" : "darker", threshold,
                  options.threshold > 0 ? "" : " (chosen by Otsu's method)")};
  work.poll();
  const auto unknown = std::count(greys.begin(), greys.end(), kRosUnknown);
  if (static_cast<double>(unknown) > 0.01 * static_cast<double>(greys.size()))
    report.push_back(fmt::format("{} pixels have grey {}, which ROS maps use for unknown; here they are {}", unknown,
                                 kRosUnknown, (kRosUnknown < threshold) != options.negate ? "walls" : "free"));
  else if (share > 0.5)
    report.push_back(
        "warning: more than half of the picture is wall; negate swaps dark and light, threshold moves the border");
  return world_from_raster(grid, image_path, options.trace, std::move(report), work);
}

}  // namespace meander

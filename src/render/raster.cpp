// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/raster.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "render/canvas.hpp"

namespace meander {
namespace {

constexpr int kOversampling = 2;  ///< painted this much larger along each side, then averaged
constexpr std::int64_t kMostPixels = kMaxPixels / (kOversampling * kOversampling);

}  // namespace

Image raster(const DrawList& list, const PictureSize& size) {
  validate(size);
  constexpr int kHighest = 16384;
  Viewport viewport = fit(list.view, size.width, size.height > 0 ? size.height : kHighest);
  const int width = std::clamp(static_cast<int>(std::lround(viewport.width)), 1, size.width);
  const int height = std::clamp(static_cast<int>(std::lround(viewport.height)), 1, kHighest);
  if (static_cast<std::int64_t>(width) * height > kMostPixels)
    fail("picture: at most {} million pixels expected, got {} x {}", kMostPixels / 1'000'000, width, height);
  viewport.scale *= kOversampling;
  Canvas canvas = blank_canvas(viewport, width * kOversampling, height * kOversampling, list.background);
  canvas.least_width = 1.25 * kOversampling;
  paint(canvas, list);
  Image image{width, height, 3,
              std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
  const cv::Mat large(canvas.image.height, canvas.image.width, CV_8UC3, canvas.image.pixels.data());
  cv::Mat small(height, width, CV_8UC3, image.pixels.data());
  cv::resize(large, small, small.size(), 0, 0, cv::INTER_AREA);
  return image;
}

}  // namespace meander

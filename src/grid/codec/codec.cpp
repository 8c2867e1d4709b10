// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// OpenCV's image codecs, kept in a module of their own because they bring some 140 shared libraries along.
#include "grid/codec/codec.hpp"

#include <exception>
#include <iostream>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace meander {
namespace {

/// What is wrong with an image is told by the error that the caller gets: OpenCV's own account of it would go to the
/// terminal.
class Quiet {
 public:
  Quiet() : before_(std::cerr.rdbuf(nullptr)) {}
  ~Quiet() { std::cerr.rdbuf(before_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  std::streambuf* before_;
};

/// 8 bits a channel, RGB order.
cv::Mat normalised(cv::Mat image) {
  if (image.depth() == CV_16U) image.convertTo(image, CV_8U, 1.0 / 257.0);
  if (image.channels() == 3) cv::cvtColor(image, image, cv::COLOR_BGR2RGB);
  if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_BGRA2RGBA);
  return image;
}

std::string decode(std::span<const std::uint8_t> bytes, Image& image) try {
  const Quiet quiet;
  const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
  cv::Mat decoded = cv::imdecode(raw, cv::IMREAD_UNCHANGED);
  if (decoded.empty()) return "damaged or of an unknown kind";
  if (decoded.depth() != CV_8U && decoded.depth() != CV_16U) return "8 or 16 bits a channel expected";
  decoded = normalised(decoded);
  const int channels = decoded.channels();
  if (channels != 1 && channels != 3 && channels != 4) return "1, 3 or 4 channels expected";
  image = {decoded.cols, decoded.rows, channels, {}};
  const auto row = static_cast<std::size_t>(decoded.cols) * static_cast<std::size_t>(channels);
  image.pixels.reserve(row * static_cast<std::size_t>(decoded.rows));
  for (int y = 0; y < decoded.rows; ++y) image.pixels.insert(image.pixels.end(), decoded.ptr(y), decoded.ptr(y) + row);
  return {};
} catch (const std::exception& error) {
  return error.what();
}

std::string encode_png(const Image& image, std::vector<std::uint8_t>& bytes) try {
  const cv::Mat rgb(image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data()));
  cv::Mat bgr = rgb;
  if (image.channels == 3) cv::cvtColor(rgb, bgr = cv::Mat(), cv::COLOR_RGB2BGR);
  if (image.channels == 4) cv::cvtColor(rgb, bgr = cv::Mat(), cv::COLOR_RGBA2BGRA);
  return cv::imencode(".png", bgr, bytes) ? "" : "the encoder refused";
} catch (const std::exception& error) {
  return error.what();
}

}  // namespace
}  // namespace meander

extern "C" const meander::Codec* meander_codec() {
  static const meander::Codec codec{meander::decode, meander::encode_png};
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  return &codec;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <optional>
#include <span>

namespace meander {

/// What the first bytes of a PNG, JPEG, BMP or TIFF file promise. Nothing is decoded.
struct ImageHeader {
  const char* kind;
  std::int64_t width = 0;  ///< 0: not found
  std::int64_t height = 0;
  bool complete = true;  ///< the file goes on to its end mark, where the kind has one
};

/// Nothing when the file is of none of these kinds.
std::optional<ImageHeader> image_header(std::span<const std::uint8_t> bytes);

}  // namespace meander

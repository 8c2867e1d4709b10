// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grid/image_file.hpp"

namespace meander {

/// What the loadable codec module offers. Nothing is thrown across its border: an empty text is success, any other says
/// what went wrong.
struct Codec {
  std::string (*decode)(std::span<const std::uint8_t> bytes, Image& image);
  std::string (*encode_png)(const Image& image, std::vector<std::uint8_t>& bytes);
};

/// The one symbol of the module: const Codec* meander_codec().
inline constexpr const char* kCodecSymbol = "meander_codec";

}  // namespace meander

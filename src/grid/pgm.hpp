// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "grid/image_file.hpp"

namespace meander {

/// Does the file start like a PGM, text (P2) or binary (P5)?
bool is_pgm(std::span<const std::uint8_t> bytes);

/// Grey image; values are scaled from 0 .. maxval to 0 .. 255. The size is judged before memory is taken. Throws
/// FileError that starts with `name`.
Image pgm_image(std::span<const std::uint8_t> bytes, const std::string& name);

/// Binary PGM of a grey image.
std::string pgm_text(const Image& image);

}  // namespace meander

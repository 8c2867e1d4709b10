// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "render/draw_list.hpp"
#include "render/raster.hpp"

namespace meander {

/// Writes the list by suffix, .svg or .png (of the given size), at once or not at all. Throws FileError where the file
/// cannot be written, ArgumentError for another suffix.
void save_picture(const std::string& path, const DrawList& list, const PictureSize& size = {});

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "grid/image_file.hpp"

namespace meander {

/// What makes a terminal with sixel graphics show an RGB image at the cursor, which ends below it. At most 256 colours:
/// alike ones become one, which leaves those of the theme as they are.
std::string sixel_picture(const Image& image);

}  // namespace meander

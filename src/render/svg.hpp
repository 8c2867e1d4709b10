// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "render/draw_list.hpp"

namespace meander {

/// The list as an SVG document, its longer side 1000 units, numbers to a hundredth. Equal lists give equal bytes.
std::string svg(const DrawList& list);

}  // namespace meander

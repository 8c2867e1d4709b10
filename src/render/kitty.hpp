// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>

namespace meander {

std::string base64(std::string_view bytes);

/// What makes a terminal with the kitty graphics protocol show a PNG at the cursor, which ends below it.
std::string kitty_picture(std::string_view png);

}  // namespace meander

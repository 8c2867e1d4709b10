// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace meander::script {

/// The same lines, those that are longer than `width` broken at blanks. What goes on stands below the line's second
/// column (behind the first gap of two blanks), else below its beginning. Words stay whole; width 0 breaks nothing.
std::string wrapped(std::string_view text, std::size_t width);

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>

namespace meander::script {

/// An example with each of its statements on a line of its own, as people write them; records keep them on one line.
std::string example_lines(std::string_view example);

/// `text` with `indent` in front of each line but the first.
std::string indented(std::string_view text, std::string_view indent);

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace meander {

// Names and messages come from scripts of others and go to terminals and XML readers: all of it as visible_text().

/// In one line.
std::string one_line(std::string_view text);
/// Its lines, without an empty one at the end.
std::vector<std::string> lines_of(std::string_view text);
/// Escaped for XML, in text and attributes alike.
std::string xml_text(std::string_view text);
/// A YAML scalar in double quotes.
std::string yaml_text(std::string_view text);

}  // namespace meander

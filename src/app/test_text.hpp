// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace meander {

// Names and messages come from scripts of others and go to terminals and XML readers.

/// Valid UTF-8 without control characters but line breaks and tabs: others become "\x1b", bytes that are no UTF-8 too.
std::string harmless(std::string_view text);
/// The same in one line.
std::string one_line(std::string_view text);
/// The lines of a harmless text, without an empty one at the end.
std::vector<std::string> lines_of(std::string_view text);
/// Harmless and escaped for XML, in text and attributes alike.
std::string xml_text(std::string_view text);
/// A YAML scalar in double quotes.
std::string yaml_text(std::string_view text);

}  // namespace meander

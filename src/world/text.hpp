// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace meander {

/// Number of characters of a UTF-8 text, or nothing when it is not UTF-8.
std::optional<std::size_t> text_length(std::string_view text);

/// Has the UTF-8 text a control character (U+0000 to 1F, 7F to 9F) other than the allowed ones?
bool has_control(std::string_view text, std::string_view allowed);

/// The text for a message of one line: control characters and stray bytes as '?', cut after `most` bytes.
std::string printable(std::string_view text, std::size_t most = 64);

/// Does the whole text fit the pattern? `*` stands for any run of characters, `?` for one character.
bool fits_pattern(std::string_view text, std::string_view pattern);

}  // namespace meander

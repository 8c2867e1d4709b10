// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>

namespace meander {

inline constexpr char32_t kReplacement = 0xFFFD;

/// The code points of UTF-8 text; every byte that is not part of a valid sequence becomes U+FFFD.
std::u32string code_points(std::string_view text);

void append_utf8(std::string& text, char32_t code);

/// Control characters, separators that break lines, direction overrides and non-characters: nothing a picture shows.
bool is_control(char32_t code);

/// Takes one column on every terminal (Latin, Greek, Cyrillic, arrows, box and block drawing). Others may be wide or
/// combine.
bool is_narrow(char32_t code);

}  // namespace meander

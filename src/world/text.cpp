// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/text.hpp"

#include <algorithm>
#include <cstdint>

namespace meander {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< 0: not UTF-8
};

/// The character at the front of a text that is not empty (RFC 3629: no overlong forms, no surrogates).
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = (code << 6) | (byte(i) & 0x3fu);
  }
  static constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return {};
  return {code, bytes};
}

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7f && code <= 0x9f); }

/// Bytes of the first character, 1 for a stray byte.
std::size_t step(std::string_view text) { return std::max<std::size_t>(1, first_character(text).bytes); }

}  // namespace

std::optional<std::size_t> text_length(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) {
    const Character c = first_character(text);
    if (c.bytes == 0) return std::nullopt;
    text.remove_prefix(c.bytes);
  }
  return count;
}

bool has_control(std::string_view text, std::string_view allowed) {
  while (!text.empty()) {
    const Character c = first_character(text);
    if (c.bytes != 0 && is_control(c.code) && allowed.find(text[0]) == std::string_view::npos) return true;
    text.remove_prefix(step(text));
  }
  return false;
}

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  while (!text.empty()) {
    const Character c = first_character(text);
    if (shown.size() + c.bytes > most) return shown + "...";
    if (c.bytes == 0 || is_control(c.code))
      shown += '?';
    else
      shown += text.substr(0, c.bytes);
    text.remove_prefix(step(text));
  }
  return shown;
}

bool fits_pattern(std::string_view text, std::string_view pattern) {
  // On a misfit the last star swallows one character more: enough, because an earlier star never needs to.
  std::optional<std::string_view> after_star;
  std::string_view star_text;
  while (!text.empty()) {
    if (!pattern.empty() && pattern[0] == '*') {
      after_star = pattern = pattern.substr(1);
      star_text = text;
    } else if (!pattern.empty() && (pattern[0] == '?' || pattern[0] == text[0])) {
      text.remove_prefix(pattern[0] == '?' ? step(text) : 1);
      pattern.remove_prefix(1);
    } else if (after_star) {
      star_text.remove_prefix(step(star_text));
      text = star_text;
      pattern = *after_star;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*') == std::string_view::npos;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/visible_text.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace meander {
namespace {

unsigned char byte(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

/// Bytes of the character at the start as its first byte tells; 0 for a byte that starts none.
std::size_t told_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

/// C0 and C1, which a terminal may take for the beginning of a command, DEL, marks that turn the direction of writing
/// round, halves of UTF-16 pairs, and what is no character, which XML forbids.
bool commands(std::uint32_t code) {
  const bool control = (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7f && code < 0xa0);
  const bool turns_round = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  const bool no_character = (code >= 0xd800 && code < 0xe000) || (code & 0xfffe) == 0xfffe || code > 0x10ffff;
  return control || turns_round || no_character;
}

/// Bytes of the character at the start; 0 where none starts that may be shown.
std::size_t character_length(std::string_view text) {
  const std::size_t length = told_length(byte(text, 0));
  if (length == 0 || length > text.size()) return 0;
  std::uint32_t code = length == 1 ? byte(text, 0) : byte(text, 0) & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(text, i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(text, i) & 0x3fu);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};  // written longer than needed is not UTF-8
  return code >= kLeast[length] && !commands(code) ? length : 0;
}

}  // namespace

std::string visible_text(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length > 0)
      shown += text.substr(0, length);
    else
      shown += fmt::format("\\{}", byte(text, 0));
    text.remove_prefix(length > 0 ? length : 1);
  }
  return shown;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/visible_text.hpp"

#include <fmt/format.h>

#include <cstddef>

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

/// 0 where no whole character starts.
std::size_t character_length(std::string_view text) {
  const std::size_t length = told_length(byte(text, 0));
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(text, i) & 0xc0) != 0x80) return 0;
  return length;
}

/// C0, DEL, and C1, which a terminal may take for the beginning of a command as well.
bool commands(std::string_view character) {
  const unsigned char first = byte(character, 0);
  if (character.size() == 2) return first == 0xc2 && byte(character, 1) < 0xa0;
  return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7f;
}

}  // namespace

std::string visible_text(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    if (length == 0 || commands(character))
      for (std::size_t i = 0; i < character.size(); ++i) shown += fmt::format("\\{}", byte(character, i));
    else
      shown += character;
    text.remove_prefix(character.size());
  }
  return shown;
}

}  // namespace meander

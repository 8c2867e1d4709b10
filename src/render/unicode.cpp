// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/unicode.hpp"

namespace meander {
namespace {

/// Length of the sequence that a first byte announces; 0: no first byte.
int sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2) return 0;
  if (first < 0xE0) return 2;
  if (first < 0xF0) return 3;
  return first < 0xF5 ? 4 : 0;
}

/// The code point at the front of `text`, or U+FFFD when the bytes do not form one; `length` says how many were read.
char32_t first_code_point(std::string_view text, std::size_t& length) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto count = static_cast<std::size_t>(sequence_length(byte(0)));
  length = 1;
  if (count == 0 || count > text.size()) return kReplacement;
  constexpr unsigned char kPayload[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
  char32_t code = byte(0) & kPayload[count];
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return kReplacement;
    code = (code << 6) | (byte(i) & 0x3F);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[count] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return kReplacement;
  length = count;
  return code;
}

}  // namespace

std::u32string code_points(std::string_view text) {
  std::u32string codes;
  for (std::size_t i = 0, length = 0; i < text.size(); i += length) codes += first_code_point(text.substr(i), length);
  return codes;
}

void append_utf8(std::string& text, char32_t code) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | (code >> 12));
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xF0 | (code >> 18));
    tail(12), tail(6), tail(0);
  }
}

bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069) || (code >= 0xFDD0 && code <= 0xFDEF) || (code & 0xFFFE) == 0xFFFE;
}

bool is_narrow(char32_t code) {
  if (code < 0x7F) return code >= 0x20;
  if ((code >= 0x2190 && code <= 0x2199) || (code >= 0x2500 && code <= 0x259F)) return true;
  const bool combining = (code >= 0x300 && code <= 0x36F) || (code >= 0x483 && code <= 0x489);
  return code >= 0xA1 && code <= 0x52F && code != 0xAD && !combining;
}

}  // namespace meander

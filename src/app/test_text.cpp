// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/test_text.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace meander {
namespace {

unsigned char byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// Bytes that the character at `i` claims to have; 0 where none can begin.
std::size_t claimed_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

/// Length of the UTF-8 character at `i` if it is one that may be shown: no overlong form, no surrogate, no control
/// character of the second block, nothing that XML forbids. Else 0.
std::size_t shown_length(std::string_view text, std::size_t i) {
  const unsigned char first = byte_at(text, i);
  const std::size_t length = claimed_length(first);
  if (length == 0 || i + length > text.size()) return 0;
  if (length == 1) return first >= 0x20 && first != 0x7f ? 1 : 0;
  std::uint32_t code = first & (0xffu >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    const unsigned char next = byte_at(text, i + k);
    if ((next & 0xc0) != 0x80) return 0;
    code = code << 6 | (next & 0x3f);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0xa0, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  const bool override_of_direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return code >= kLeast[length] && code <= 0x10ffff && !surrogate && !override_of_direction && (code & 0xfffe) != 0xfffe
             ? length
             : 0;
}

template <class Put>
std::string rewritten(std::string_view text, Put put) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = shown_length(text, i);
    if (put(result, text[i])) {
      ++i;
    } else if (length > 0) {
      result += text.substr(i, length);
      i += length;
    } else {
      result += fmt::format("\\x{:02x}", byte_at(text, i));
      ++i;
    }
  }
  return result;
}

}  // namespace

std::string harmless(std::string_view text) {
  return rewritten(text, [](std::string& result, char c) {
    if (c != '\n' && c != '\t') return false;
    result += c;
    return true;
  });
}

std::string one_line(std::string_view text) {
  return rewritten(text, [](std::string& result, char c) {
    if (c != '\n' && c != '\t') return false;
    result += c == '\n' ? "\\n" : " ";
    return true;
  });
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : harmless(text)) {
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

std::string xml_text(std::string_view text) {
  return rewritten(text, [](std::string& result, char c) {
    switch (c) {
      case '<':
        return result += "&lt;", true;
      case '>':
        return result += "&gt;", true;
      case '&':
        return result += "&amp;", true;
      case '"':
        return result += "&quot;", true;
      case '\n':
        return result += "&#10;", true;
      case '\t':
        return result += "&#9;", true;
      default:
        return false;
    }
  });
}

std::string yaml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : harmless(text)) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n')
      result += "\\n";
    else if (c == '\t')
      result += "\\t";
    else
      result += c;
  }
  return result + '"';
}

}  // namespace meander

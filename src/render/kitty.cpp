// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/kitty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace meander {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string kitty_picture(std::string_view png) {
  constexpr std::size_t kChunk = 4096;  // the largest payload of one command
  const std::string text = base64(png);
  std::string out;
  for (std::size_t from = 0; from < text.size(); from += kChunk) {
    // a=T: transmit and show, f=100: PNG, q=2: no answers, m=1: more follows
    const bool more = from + kChunk < text.size();
    out += fmt::format("\x1b_G{}m={};{}\x1b\\", from == 0 ? "a=T,f=100,q=2," : "", more ? 1 : 0,
                       text.substr(from, kChunk));
  }
  return out + "\n";
}

}  // namespace meander

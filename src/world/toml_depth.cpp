// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/toml_depth.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace meander {
namespace {

constexpr int kMostParts = 64;

bool belongs_to_key(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == ' ' || c == '\t';
}

/// The position behind the string that starts with the quote at `start`; basic strings have escapes, literal ones none.
std::size_t behind_string(std::string_view text, std::size_t start) {
  const char quote = text[start];
  const std::string three(3, quote);
  const bool multiline = text.substr(start, 3) == three;
  for (std::size_t i = start + (multiline ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (!multiline && (text[i] == quote || text[i] == '\n'))
      return i + 1;
    else if (multiline && text.substr(i, 3) == three)
      return std::min(text.find_first_not_of(quote, i), i + 5);  // one or two quotes may stand before the closing three
  }
  return text.size();
}

}  // namespace

void check_key_depth(std::string_view text, const std::string& path) {
  int parts = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = behind_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.')
      ++parts;
    else if (!belongs_to_key(c))
      parts = 1;
    if (parts > kMostParts)
      fail<FileError>("{}:{}: a key of more than {} parts", path,
                      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n'), kMostParts);
    ++i;
  }
}

}  // namespace meander

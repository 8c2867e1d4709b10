// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

namespace meander::script {

/// A piece of Lua text. Comments and spaces are left out; a text or comment that is not closed reaches to the end.
struct Token {
  enum class Kind { name, number, text, open_text, open_comment, symbol };
  Kind kind;
  std::string_view text;  ///< of texts what is between the quotes, escapes as they stand
  std::size_t start;      ///< of the token, quote included

  bool is(std::string_view symbol) const { return kind == Kind::symbol && text == symbol; }
};

/// Splits Lua that may break off anywhere. Never fails: what is no Lua becomes symbols.
std::vector<Token> tokens_of(std::string_view lua);

}  // namespace meander::script

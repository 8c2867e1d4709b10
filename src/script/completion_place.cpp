// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion_place.hpp"

#include <algorithm>

#include "script/completion_chain.hpp"

namespace meander::script {
namespace {

using Kind = Token::Kind;

/// The innermost bracket that is open before token `end`; counts the commas behind it.
std::optional<std::size_t> open_bracket(const Tokens& tokens, std::size_t end, std::size_t& commas) {
  commas = 0;
  for (std::size_t i = end; i-- > 0;) {
    const Token& token = tokens[i];
    if (token.is("(") || token.is("{") || token.is("[")) return i;
    if (token.is(",")) ++commas;
    if (!token.is(")") && !token.is("}") && !token.is("]")) continue;
    i = matching_open(tokens, i);
    if (i >= end) return std::nullopt;
  }
  return std::nullopt;
}

const OptionDoc* option_named(const std::vector<OptionDoc>& options, std::string_view name) {
  const auto found = std::find_if(options.begin(), options.end(), [&](const OptionDoc& o) { return o.name == name; });
  return found == options.end() ? nullptr : &*found;
}

}  // namespace

std::optional<CallPlace> place_of(const Tokens& tokens) {
  CallPlace place;
  std::size_t commas = 0;
  auto open = open_bracket(tokens, tokens.size(), commas);
  place.in_table = open && tokens[*open].is("{");
  while (open && tokens[*open].is("{")) {
    const std::size_t at = *open;
    const bool is_option = at >= 2 && tokens[at - 1].is("=") && tokens[at - 2].kind == Kind::name;
    const bool is_element = at >= 1 && tokens[at - 1].is("{");
    const bool is_argument = at >= 1 && (tokens[at - 1].is("(") || tokens[at - 1].is(","));
    if (!is_option && !is_element && !is_argument) return place.function_end = at, place;
    if (is_option) place.keys.insert(place.keys.begin(), std::string(tokens[at - 2].text));
    open = open_bracket(tokens, at, commas);
  }
  if (!open || !tokens[*open].is("(")) return std::nullopt;
  place.function_end = *open;
  place.argument = commas;
  return place;
}

const ArgumentDoc* argument_at(lua_State* L, const Tokens& tokens, const CallPlace& place) {
  const auto called = subject_before(L, tokens, place.function_end);
  if (!called || !called->record || place.argument >= called->record->arguments.size()) return nullptr;
  return &called->record->arguments[place.argument];
}

const OptionDoc* option_at(const ArgumentDoc& argument, const std::vector<std::string>& keys) {
  const std::vector<OptionDoc>* options = &argument.options;
  const OptionDoc* option = nullptr;
  for (const std::string& key : keys) {
    option = option_named(*options, key);
    if (!option) return nullptr;
    options = &option->options;
  }
  return option;
}

}  // namespace meander::script

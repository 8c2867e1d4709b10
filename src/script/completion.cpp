// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion.hpp"

#include <lauxlib.h>

#include <algorithm>
#include <array>

#include "script/completion_chain.hpp"
#include "script/completion_place.hpp"
#include "script/completion_text.hpp"

namespace meander::script {
namespace {

using Kind = Token::Kind;

constexpr std::array kKeywords = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                  "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                  "repeat",   "return", "then", "true", "until",  "while"};

std::vector<std::string> option_names(lua_State* L, const Tokens& tokens) {
  const auto place = place_of(tokens);
  if (!place || !place->in_table) return {};
  if (!tokens.back().is("{") && !tokens.back().is(",") && !tokens.back().is(";")) return {};
  const ArgumentDoc* argument = argument_at(L, tokens, *place);
  if (!argument) return {};
  const OptionDoc* table = option_at(*argument, place->keys);
  std::vector<std::string> names;
  if (table || place->keys.empty())
    for (const OptionDoc& option : table ? table->options : argument->options) names.push_back(option.name + " = ");
  return names;
}

std::vector<std::string> global_names(lua_State* L) {
  std::vector<std::string> names(kKeywords.begin(), kKeywords.end());
  lua_pushglobaltable(L);
  for (const std::string& name : member_names(L, {.live = true}, false)) names.push_back(name);
  lua_pushliteral(L, "meander");
  if (lua_rawget(L, -2) == LUA_TTABLE)
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
      if (lua_type(L, -2) == LUA_TSTRING && lua_istable(L, -1)) names.emplace_back(lua_tostring(L, -2));
  return names;
}

/// What may follow the tokens, of which the word itself is none.
std::vector<std::string> names_after(lua_State* L, const Tokens& tokens) {
  if (tokens.empty()) return global_names(L);
  const bool method = tokens.back().is(":");
  if (method || tokens.back().is(".")) {
    const auto owner = subject_before(L, tokens, tokens.size() - 1);
    return owner ? member_names(L, *owner, method) : std::vector<std::string>();
  }
  std::vector<std::string> names = option_names(L, tokens);
  return names.empty() ? global_names(L) : names;
}

void keep_those_that_start(std::string_view word, std::vector<std::string>& words) {
  std::erase_if(words, [&](const std::string& candidate) {
    const bool internal = word.empty() && candidate.starts_with("_");
    return internal || !candidate.starts_with(word);
  });
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
}

Completion find(lua_State* L, std::string_view text) {
  Tokens tokens = tokens_of(text);
  Completion completion{.start = text.size()};
  if (!tokens.empty() && tokens.back().kind == Kind::open_comment) return completion;
  if (!tokens.empty() && tokens.back().kind == Kind::open_text) {
    completion = complete_text(L, tokens);
  } else {
    const bool in_word = !tokens.empty() && tokens.back().kind == Kind::name &&
                         tokens.back().start + tokens.back().text.size() == text.size();
    if (in_word) completion.start = tokens.back().start;
    if (in_word) tokens.pop_back();
    completion.words = names_after(L, tokens);
  }
  keep_those_that_start(text.substr(completion.start), completion.words);
  return completion;
}

/// Arguments: the text and where to put what was found, as light userdata.
int find_protected(lua_State* L) {
  const auto& text = *static_cast<const std::string_view*>(lua_touserdata(L, 1));
  *static_cast<Completion*>(lua_touserdata(L, 2)) = find(L, text);
  return 0;
}

}  // namespace

Completion complete(lua_State* L, std::string_view text) {
  Completion completion{.start = text.size()};
  lua_pushcfunction(L, find_protected);
  lua_pushlightuserdata(L, &text);
  lua_pushlightuserdata(L, &completion);
  if (lua_pcall(L, 2, 0, 0) != LUA_OK) lua_pop(L, 1);  // out of memory: nothing to offer
  return completion;
}

}  // namespace meander::script

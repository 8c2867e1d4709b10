// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion.hpp"

#include <lauxlib.h>

#include <algorithm>
#include <array>
#include <optional>

#include "script/completion_chain.hpp"
#include "script/help_text.hpp"
#include "script/lua_embedded.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

using Kind = Token::Kind;
using Tokens = std::vector<Token>;

constexpr std::array kKeywords = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                  "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                  "repeat",   "return", "then", "true", "until",  "while"};

constexpr std::string_view kModule = "meander.";  // what names may do without

/// Where in the arguments of a call, or in its option table, the end of a text stands.
struct Place {
  std::size_t function_end = 0;     ///< the token behind the function's name
  std::size_t argument = 0;         ///< counted from 0
  std::vector<std::string> keys{};  ///< of the option tables around, outermost first
  bool in_table = false;
};

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

/// Follows the brackets outwards: tables that are options of tables, or elements of lists that are, up to the call they
/// belong to.
std::optional<Place> place_of(const Tokens& tokens) {
  Place place;
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

const OptionDoc* option_named(const std::vector<OptionDoc>& options, std::string_view name) {
  const auto found = std::find_if(options.begin(), options.end(), [&](const OptionDoc& o) { return o.name == name; });
  return found == options.end() ? nullptr : &*found;
}

const ArgumentDoc* argument_at(lua_State* L, const Tokens& tokens, const Place& place) {
  const auto called = subject_before(L, tokens, place.function_end);
  if (!called || !called->record || place.argument >= called->record->arguments.size()) return nullptr;
  return &called->record->arguments[place.argument];
}

const std::vector<OptionDoc>* options_at(const ArgumentDoc& argument, const Place& place) {
  const std::vector<OptionDoc>* options = &argument.options;
  for (const std::string& key : place.keys) {
    const OptionDoc* option = option_named(*options, key);
    if (!option) return nullptr;
    options = &option->options;
  }
  return options;
}

/// The key of `key = "...`, where the text is the last token; empty elsewhere.
std::string_view key_of_last_text(const Tokens& tokens) {
  const std::size_t count = tokens.size();
  return count >= 3 && tokens[count - 2].is("=") && tokens[count - 3].kind == Kind::name ? tokens[count - 3].text
                                                                                         : std::string_view();
}

/// The texts that the option or argument takes whose quotes are open at the end, if it takes only some.
std::vector<std::string> values_of_text(lua_State* L, const Tokens& tokens) {
  Tokens before(tokens.begin(), tokens.end() - 1);
  auto place = place_of(before);
  const bool bare = !before.empty() && (before.back().kind == Kind::name || before.back().is(")"));
  if (bare) place = Place{.function_end = before.size()};
  const ArgumentDoc* argument = place ? argument_at(L, before, *place) : nullptr;
  if (!argument) return {};
  if (!place->in_table) return argument->values;
  const std::vector<OptionDoc>* options = options_at(*argument, *place);
  const OptionDoc* option = options ? option_named(*options, key_of_last_text(tokens)) : nullptr;
  return option ? option->values : std::vector<std::string>();
}

/// `name "` or `name("` at the end of the tokens.
bool calls(const Tokens& tokens, std::string_view name) {
  std::size_t at = tokens.size() - 1;
  if (at > 0 && tokens[at - 1].is("(")) --at;
  return at > 0 && tokens[at - 1].kind == Kind::name && tokens[at - 1].text == name;
}

/// readline takes dots and spaces for word breaks, but not inside quotes.
Completion complete_text(lua_State* L, const Tokens& tokens) {
  Completion completion{.start = tokens.back().start + 1};
  completion.words = values_of_text(L, tokens);
  if (calls(tokens, "require"))
    for (const EmbeddedModule& module : embedded_modules()) completion.words.emplace_back(module.name);
  if (calls(tokens, "help"))
    for (const std::string& name : record_names(session(L).docs)) {
      completion.words.push_back(name);
      if (name.starts_with(kModule)) completion.words.push_back(name.substr(kModule.size()));
    }
  completion.file_name = completion.words.empty();
  return completion;
}

std::vector<std::string> option_names(lua_State* L, const Tokens& tokens) {
  const auto place = place_of(tokens);
  if (!place || !place->in_table) return {};
  if (!tokens.back().is("{") && !tokens.back().is(",") && !tokens.back().is(";")) return {};
  const ArgumentDoc* argument = argument_at(L, tokens, *place);
  const std::vector<OptionDoc>* options = argument ? options_at(*argument, *place) : nullptr;
  std::vector<std::string> names;
  if (options)
    for (const OptionDoc& option : *options) names.push_back(option.name + " = ");
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

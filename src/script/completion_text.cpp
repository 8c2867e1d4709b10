// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion_text.hpp"

#include "script/completion_files.hpp"
#include "script/completion_world.hpp"
#include "script/help_text.hpp"
#include "script/lua_embedded.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

using Kind = Token::Kind;

constexpr std::string_view kModule = "meander.";  // what names may do without

/// The text of an argument, an option, or an element of a list that is one of them.
struct Wanted {
  std::string_view type, text;
  std::vector<std::string> values;

  bool mentions(std::string_view word) const { return type.find(word) != std::string_view::npos; }
};

/// The key of `key = "...`, where the text is the last token; empty elsewhere.
std::string_view key_of_last_text(const Tokens& tokens) {
  const std::size_t count = tokens.size();
  return count >= 3 && tokens[count - 2].is("=") && tokens[count - 3].kind == Kind::name ? tokens[count - 3].text
                                                                                         : std::string_view();
}

/// Where the text stands, which is the last token: `f("`, `f "`, `f { key = "`.
std::optional<CallPlace> place_of_text(const Tokens& tokens) {
  const Tokens before(tokens.begin(), tokens.end() - 1);
  const bool bare = !before.empty() && (before.back().kind == Kind::name || before.back().is(")"));
  if (bare) return CallPlace{.function_end = before.size()};
  auto place = place_of(before);
  if (const auto key = key_of_last_text(tokens); place && !key.empty()) place->keys.emplace_back(key);
  return place;
}

Wanted wanted_at(const ArgumentDoc& argument, const CallPlace& place) {
  if (place.keys.empty()) return {argument.type, argument.text, argument.values};
  const OptionDoc* option = option_at(argument, place.keys);
  return option ? Wanted{option->type, option->text, option->values} : Wanted{};
}

void add_names_of_things(lua_State* L, const Tokens& tokens, const CallPlace& place, const Wanted& wanted,
                         std::vector<std::string>& words) {
  const bool places_only = wanted.mentions("place");
  if (!places_only && !wanted.type.starts_with("thing")) return;
  if (const auto world = world_meant(L, tokens, place.function_end))
    for (const std::string& name : things_of(*world, places_only)) words.push_back(name);
}

void add_files(std::string_view start, const Wanted& wanted, Completion& completion) {
  const std::vector<std::string> suffixes = suffixes_in(wanted.text);
  if (suffixes.empty())
    completion.file_name = true;
  else
    completion.words = files_with(suffixes, std::string(start));
}

/// `name "` or `name("` at the end of the tokens.
bool calls(const Tokens& tokens, std::string_view name) {
  std::size_t at = tokens.size() - 1;
  if (at > 0 && tokens[at - 1].is("(")) --at;
  return at > 0 && tokens[at - 1].kind == Kind::name && tokens[at - 1].text == name;
}

}  // namespace

/// readline takes dots and spaces for word breaks, but not inside quotes.
Completion complete_text(lua_State* L, const Tokens& tokens) {
  Completion completion{.start = tokens.back().start + 1};
  if (calls(tokens, "require")) {
    for (const EmbeddedModule& module : embedded_modules()) completion.words.emplace_back(module.name);
    return completion;
  }
  if (calls(tokens, "help")) {
    for (const std::string& name : record_names(session(L).docs)) {
      completion.words.push_back(name);
      if (name.starts_with(kModule)) completion.words.push_back(name.substr(kModule.size()));
    }
    return completion;
  }
  const auto place = place_of_text(tokens);
  const ArgumentDoc* argument = place ? argument_at(L, tokens, *place) : nullptr;
  completion.file_name = !argument;
  if (!argument) return completion;
  const Wanted wanted = wanted_at(*argument, *place);
  completion.words = wanted.values;
  add_names_of_things(L, tokens, *place, wanted, completion.words);
  if (wanted.type == "file name") add_files(tokens.back().text, wanted, completion);
  return completion;
}

}  // namespace meander::script

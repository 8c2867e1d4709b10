// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion_world.hpp"

#include "script/completion_chain.hpp"
#include "script/objects.hpp"

namespace meander::script {
namespace {

using Kind = Token::Kind;

/// Of the value on top.
std::shared_ptr<const World> world_of_value(lua_State* L) {
  const auto object = [&]<class T>(std::type_identity<T>) {
    const ObjectBox* box = test_box(L, -1, tag_of<T>);
    return box ? std::static_pointer_cast<const T>(box->object) : nullptr;
  };
  if (const auto sim = object(std::type_identity<Sim>{})) return sim->shared_world();
  if (const auto run = object(std::type_identity<RunRecord>{})) return run->world;
  return object(std::type_identity<World>{});
}

/// Of the expression that ends before token `end`: a world, or what has one.
std::shared_ptr<const World> world_before(lua_State* L, const Tokens& tokens, std::size_t end) {
  const bool is_member = end >= 3 && tokens[end - 1].text == "world" && tokens[end - 2].is(".");
  if (is_member)
    if (auto world = world_before(L, tokens, end - 2)) return world;
  const auto subject = subject_before(L, tokens, end);
  return subject && subject->live ? world_of_value(L) : nullptr;
}

/// The comma or bracket that ends the expression at `from`, or the end of the tokens.
std::size_t end_of_expression(const Tokens& tokens, std::size_t from) {
  int depth = 0;
  for (std::size_t i = from; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (depth == 0 && (token.is(",") || token.is("}") || token.is(")"))) return i;
    if (token.is("(") || token.is("{") || token.is("[")) ++depth;
    if (token.is(")") || token.is("}") || token.is("]")) --depth;
  }
  return tokens.size();
}

}  // namespace

std::shared_ptr<const World> world_meant(lua_State* L, const Tokens& tokens, std::size_t function_end) {
  if (function_end >= 3 && tokens[function_end - 2].is(":")) return world_before(L, tokens, function_end - 2);
  if (auto world = world_before(L, tokens, end_of_expression(tokens, function_end + 1))) return world;
  for (std::size_t i = function_end; i + 1 < tokens.size(); ++i)
    if (tokens[i].kind == Kind::name && tokens[i].text == "world" && tokens[i + 1].is("="))
      return world_before(L, tokens, end_of_expression(tokens, i + 2));
  return nullptr;
}

std::vector<std::string> things_of(const World& world, bool places_only) {
  if (!places_only) return world.names();
  std::vector<std::string> names;
  for (const Id id : world.ids())
    if (const auto* place = std::get_if<Place>(&world.item(id))) names.push_back(place->name);
  return names;
}

}  // namespace meander::script

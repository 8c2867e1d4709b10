// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion_chain.hpp"

#include <lauxlib.h>

#include <algorithm>
#include <charconv>

#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

using Kind = Token::Kind;
constexpr int kLongestIndexChain = 20;  // metatables may form a ring
constexpr std::size_t npos = static_cast<std::size_t>(-1);

bool closes(const Token& token) { return token.is(")") || token.is("]") || token.is("}"); }
bool opens(const Token& token) { return token.is("(") || token.is("[") || token.is("{"); }

/// Replaces the value on top by its metatable's __index, if that is a table.
bool follow_index(lua_State* L) {
  if (!lua_getmetatable(L, -1)) return false;
  lua_pushliteral(L, "__index");
  lua_rawget(L, -2);
  lua_remove(L, -2);
  if (!lua_istable(L, -1)) return lua_pop(L, 1), false;
  lua_remove(L, -2);
  return true;
}

/// Replaces table or string and key on top by the field, raw but along __index tables.
bool raw_field(lua_State* L) {
  for (int i = 0; i < kLongestIndexChain; ++i) {
    lua_pushvalue(L, -2);
    if (lua_istable(L, -1)) {
      lua_pushvalue(L, -2);
      if (lua_rawget(L, -2) != LUA_TNIL) return lua_replace(L, -4), lua_pop(L, 2), true;
      lua_pop(L, 1);
    }
    if (!follow_index(L)) break;
    lua_replace(L, -3);
  }
  return false;
}

Subject subject_on_top(lua_State* L) {
  Subject subject{.live = true};
  const Record* record = record_of(L, -1);
  if (record && record->kind == DocKind::type) subject.type = record->name();
  if (record && lua_isfunction(L, -1)) subject.record = record;
  return subject;
}

std::optional<Subject> root(lua_State* L, std::string_view name) {
  lua_pushglobaltable(L);
  lua_pushlstring(L, name.data(), name.size());
  if (lua_rawget(L, -2) != LUA_TNIL) return subject_on_top(L);
  lua_pushliteral(L, "meander");
  if (lua_rawget(L, -3) != LUA_TTABLE) return std::nullopt;
  lua_pushlstring(L, name.data(), name.size());
  if (lua_rawget(L, -2) == LUA_TNIL) return std::nullopt;
  return subject_on_top(L);
}

/// What the record promises to return; a type only where it is one of the bindings.
std::optional<Subject> promised(lua_State* L, const Record* record) {
  if (!record) return std::nullopt;
  constexpr std::string_view kList = "list of ";
  std::string_view types = record->returns_type;  // "run or list of run", "world, list of string"
  types = types.substr(0, std::min(types.find(" or "), types.find(',')));
  const bool list = types.starts_with(kList);
  const Record* type = session(L).docs.find(list ? types.substr(kList.size()) : types);
  if (!type || type->kind != DocKind::type) return std::nullopt;
  return list ? Subject{.element = type->name()} : Subject{.type = type->name()};
}

std::optional<Subject> member_of(lua_State* L, const Subject& subject, std::string_view name) {
  if (!subject.type.empty()) {
    const Record* member = session(L).docs.find(subject.type + "." + std::string(name));
    if (member && member->kind == DocKind::method) return Subject{.record = member};
    return promised(L, member);
  }
  if (!subject.live) return std::nullopt;
  lua_pushlstring(L, name.data(), name.size());
  return raw_field(L) ? std::optional(subject_on_top(L)) : std::nullopt;
}

std::optional<Subject> element_of(lua_State* L, const Subject& subject, const Token& key) {
  if (key.kind == Kind::text) return member_of(L, subject, key.text);
  if (!subject.element.empty()) return Subject{.type = subject.element};
  if (!subject.type.empty()) return promised(L, session(L).docs.element(subject.type));
  lua_Integer index = 0;
  const char* end = key.text.data() + key.text.size();
  if (key.kind != Kind::number || std::from_chars(key.text.data(), end, index).ptr != end) return std::nullopt;
  if (!subject.live || !lua_istable(L, -1)) return std::nullopt;
  return lua_rawgeti(L, -1, index) == LUA_TNIL ? std::nullopt : std::optional(subject_on_top(L));
}

bool is_field_mark(const Token& token) { return token.is(".") || token.is(":"); }

void add_keys(lua_State* L, bool methods, std::vector<std::string>& names) {
  for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
    const bool wanted = !methods || lua_isfunction(L, -1);
    if (wanted && lua_type(L, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -2));
  }
}

}  // namespace

std::size_t matching_open(const std::vector<Token>& tokens, std::size_t closing) {
  int depth = 0;
  for (std::size_t i = closing + 1; i-- > 0;) {
    if (closes(tokens[i])) ++depth;
    if (opens(tokens[i]) && --depth == 0) return i;
  }
  return npos;
}

std::optional<Subject> subject_before(lua_State* L, const std::vector<Token>& tokens, std::size_t end) {
  luaL_checkstack(L, 10, nullptr);
  if (end == 0) return std::nullopt;
  const std::size_t last = end - 1;
  const Token& token = tokens[last];
  if (token.kind == Kind::name) {
    if (last == 0 || !is_field_mark(tokens[last - 1])) return root(L, token.text);
    const auto owner = subject_before(L, tokens, last - 1);
    return owner ? member_of(L, *owner, token.text) : std::nullopt;
  }
  const bool call_with_text = token.kind == Kind::text && last > 0 && tokens[last - 1].kind == Kind::name;
  if (!closes(token) && !call_with_text) return std::nullopt;
  const std::size_t open = call_with_text ? last : matching_open(tokens, last);
  if (open == npos) return std::nullopt;
  const auto called = subject_before(L, tokens, open);
  if (!called) return std::nullopt;
  if (!token.is("]")) return promised(L, called->record);
  return last == open + 2 ? element_of(L, *called, tokens[open + 1]) : std::nullopt;
}

std::vector<std::string> member_names(lua_State* L, const Subject& subject, bool methods) {
  std::vector<std::string> names;
  if (!subject.type.empty()) {
    for (const Record* member : session(L).docs.members(subject.type))
      if (member->kind == DocKind::method || (!methods && member->kind == DocKind::property))
        names.push_back(member->member);
    return names;
  }
  if (!subject.live) return names;
  lua_pushvalue(L, -1);
  for (int i = 0; i < kLongestIndexChain; ++i) {
    if (lua_istable(L, -1)) add_keys(L, methods, names);
    if (!follow_index(L)) break;
  }
  lua_pop(L, 1);
  return names;
}

}  // namespace meander::script

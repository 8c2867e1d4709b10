// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/kit_type.hpp"

#include <lauxlib.h>

#include "script/kit_module.hpp"

namespace meander::script {
namespace {

const char kTypeRecord = 0;  ///< keys the record of a type in its metatable
const char kMembers = 0;     ///< keys the member table in the metatable
const char kElement = 0;     ///< keys the reader of integer keys in the member table

[[noreturn]] void no_member(lua_State* L, const Record& type, bool setting) {
  std::vector<std::string> names, known;
  for (const Record* member : session(L).docs.members(type.name())) {
    names.push_back(member->member);
    if (!setting || member->settable) known.push_back(member->member);
  }
  const std::string key =
      lua_type(L, 2) == LUA_TSTRING ? "'" + std::string(lua_tostring(L, 2)).substr(0, 60) + "'" : describe(L, 2);
  const std::string plain = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  if (const Record* namesake = session(L).docs.find("meander." + type.name() + "." + plain); namesake && !setting)
    fail("has no member {}; the module has it: {}", key, namesake->name());
  fail("has no {} {}{}{}", setting ? "property to set called" : "member", key, did_you_mean(plain, names),
       known.empty() ? "" : " (known: " + listing(known) + ")");
}

const Record& own_type(lua_State* L) { return *static_cast<const Record*>(lua_touserdata(L, lua_upvalueindex(2))); }

/// __index: upvalues are the member table and the type's record.
int index(lua_State* L) {
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  const int found = lua_rawget(L, lua_upvalueindex(1));
  if (found == LUA_TFUNCTION) return 1;
  if (found == LUA_TUSERDATA) {
    const auto& property = *static_cast<const Property*>(lua_touserdata(L, -1));
    return property.get(L, *property.record);
  }
  if (lua_isinteger(L, 2) && lua_rawgetp(L, lua_upvalueindex(1), &kElement) == LUA_TUSERDATA) {
    const auto& element = *static_cast<const Property*>(lua_touserdata(L, -1));
    return element.get(L, *element.record);
  }
  return border(L, own_type(L), [&]() -> int { no_member(L, own_type(L), false); });
}

/// __newindex
int set_index(lua_State* L) {
  lua_settop(L, 3);
  lua_pushvalue(L, 2);
  const int found = lua_rawget(L, lua_upvalueindex(1));
  if (found == LUA_TUSERDATA) {
    const auto& property = *static_cast<const Property*>(lua_touserdata(L, -1));
    if (property.set) return property.set(L, *property.record);
    return border(L, *property.record, []() -> int { fail("cannot be set"); });
  }
  if (found == LUA_TFUNCTION)
    return border(L, own_type(L), [&]() -> int { fail("'{}' cannot be set", lua_tostring(L, 2)); });
  return border(L, own_type(L), [&]() -> int { no_member(L, own_type(L), true); });
}

void set_member_function(lua_State* L, const char* event, lua_CFunction function, Record& record) {
  // Stack: metatable, members.
  lua_pushvalue(L, -1);
  lua_pushlightuserdata(L, &record);
  lua_pushcclosure(L, function, 2);
  lua_setfield(L, -3, event);
}

/// Pushes metatable and member table.
void push_type(lua_State* L, const TypeTag& tag) {
  push_metatable(L, tag);
  lua_rawgetp(L, -1, &kMembers);
}

void push_function(lua_State* L, const Record& record, lua_CFunction function) {
  lua_pushlightuserdata(L, const_cast<Record*>(&record));
  lua_pushcclosure(L, function, 1);
}

}  // namespace

const Record* type_record(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TUSERDATA || !lua_getmetatable(L, index)) return nullptr;
  lua_rawgetp(L, -1, &kTypeRecord);
  const auto* record = static_cast<const Record*>(lua_touserdata(L, -1));
  lua_pop(L, 2);
  return record;
}

TypeBuilder::TypeBuilder(lua_State* L, const TypeTag& tag, const char* text) : L_(L), tag_(tag) {
  Record& record = session(L).docs.add({.kind = DocKind::type, .member = tag.name, .text = text});
  push_metatable(L, tag);
  lua_pushlightuserdata(L, &record);
  lua_rawsetp(L, -2, &kTypeRecord);
  lua_newtable(L);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, -3, &kMembers);
  set_member_function(L, "__index", index, record);
  set_member_function(L, "__newindex", set_index, record);
  lua_pop(L, 2);
}

void TypeBuilder::add_method(Record record, lua_CFunction function) {
  const Record& kept = session(L_).docs.add(std::move(record));
  push_type(L_, tag_);
  push_function(L_, kept, function);
  remember_record(L_, kept);
  lua_setfield(L_, -2, kept.member.c_str());
  lua_pop(L_, 2);
}

void TypeBuilder::add_property(Record record, int (*get)(lua_State*, const Record&),
                               int (*set)(lua_State*, const Record&)) {
  const Record& kept = session(L_).docs.add(std::move(record));
  push_type(L_, tag_);
  *static_cast<Property*>(lua_newuserdatauv(L_, sizeof(Property), 0)) = {&kept, get, set};
  lua_setfield(L_, -2, kept.member.c_str());
  lua_pop(L_, 2);
}

void TypeBuilder::add_event(const char* event, const char* shown_as, lua_CFunction function) {
  const Record& kept =
      session(L_).docs.add({.kind = DocKind::metamethod, .owner = tag_.name, .member = shown_as, .text = ""});
  push_type(L_, tag_);
  push_function(L_, kept, function);
  lua_setfield(L_, -3, event);
  lua_pop(L_, 2);
}

void TypeBuilder::add_element(std::string type, int (*get)(lua_State*, const Record&)) {
  const Record& kept = session(L_).docs.add(
      {.kind = DocKind::metamethod, .owner = tag_.name, .member = kElementName, .returns_type = std::move(type)});
  push_type(L_, tag_);
  *static_cast<Property*>(lua_newuserdatauv(L_, sizeof(Property), 0)) = {&kept, get, nullptr};
  lua_rawsetp(L_, -2, &kElement);
  lua_pop(L_, 2);
}

}  // namespace meander::script

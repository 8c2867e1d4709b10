// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lauxlib.h>

#include <algorithm>
#include <cmath>

#include "script/kit_value.hpp"

namespace meander::script {

/// An option that must be given.
template <class T>
struct Required {
  T value{};
};

/// Options that also have named standard sets: a script gives a name, or a table whose key `preset` names the set that
/// its other keys change. Specialise PresetSource<T> with get(name) and names().
template <class T>
struct PresetSource;
template <class T>
struct Preset {
  T value{};
};

/// Walks an option table: every key must be one of `known`. Throws "unknown option 'sede'; did you mean 'seed'? (...)".
void check_keys(lua_State* L, int table, const Path& path, const std::vector<std::string>& known);
/// Pushes table[name] without running the script's metamethods.
void push_option(lua_State* L, int table, const char* name);
/// "sonar." for nested options, "" at the top: goes in front of names in validate()'s messages.
std::string option_prefix(const Path& path);

template <class T>
struct OptionTraits {
  static constexpr bool required = false;
  using Value = T;
};
template <class T>
struct OptionTraits<Required<T>> {
  static constexpr bool required = true;
  using Value = T;
};

/// Reads the keys of a table into the members that fields() lists; members without a key keep their value.
/// No table at all is an empty one. `also` is one more key that the caller reads.
template <Listed Options>
void read_fields(lua_State* L, int index, const Path& path, Options& options, const char* also = nullptr) {
  luaL_checkstack(L, 4, nullptr);
  const bool given = !lua_isnoneornil(L, index);
  const int table = lua_absindex(L, index);
  if (given) {
    if (!lua_istable(L, index)) expected(L, index, path, "table of options");
    std::vector<std::string> known = field_names<Options>();
    if (also) known.emplace_back(also);
    check_keys(L, table, path, known);
  }
  fields(options, [&](const Field& field, auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    const Path option{.kind = Path::Kind::option, .name = field.name, .parent = &path};
    if (given)
      push_option(L, table, field.name);
    else
      lua_pushnil(L);
    if constexpr (OptionTraits<Member>::required) {
      if (lua_isnil(L, -1)) fail("{}: missing, {} expected", option.text(), Lua<decltype(member.value)>::type());
    }
    if (!lua_isnil(L, -1)) {
      if constexpr (Listed<Member>)
        read_fields(L, -1, option, member);
      else if constexpr (OptionTraits<Member>::required)
        member.value = Lua<decltype(member.value)>::read(L, -1, option);
      else
        member = Lua<Member>::read(L, -1, option);
    }
    lua_pop(L, 1);
  });
}

template <Listed Options>
struct Lua<Options> {
  static Options read(lua_State* L, int index, const Path& path) {
    Options options{};
    read_fields(L, index, path, options);
    validate(options, option_prefix(path));
    return options;
  }
  static void push(lua_State* L, const Options& options) {
    lua_newtable(L);
    fields(options, [&](const Field& field, const auto& value) {
      script::push(L, value);
      lua_setfield(L, -2, field.name);
    });
  }
  static std::string type() { return "table"; }
};

template <class T>
struct Lua<Preset<T>> {
  static Preset<T> read(lua_State* L, int index, const Path& path) {
    Preset<T> result;
    if (lua_type(L, index) == LUA_TSTRING) {
      result.value = named(L, index, path);
      return result;
    }
    if (!lua_istable(L, index)) expected(L, index, path, type());
    const int table = lua_absindex(L, index);
    push_option(L, table, "preset");
    if (!lua_isnil(L, -1))
      result.value = named(L, -1, Path{.kind = Path::Kind::option, .name = "preset", .parent = &path});
    lua_pop(L, 1);
    read_fields(L, table, path, result.value, "preset");
    validate(result.value, option_prefix(path));
    return result;
  }
  static std::string type() { return "name or table of options"; }

 private:
  static T named(lua_State* L, int index, const Path& path) {
    const std::string name(read_text(L, index, path));
    const std::vector<std::string> known = PresetSource<T>::names();
    if (std::find(known.begin(), known.end(), name) == known.end()) unknown_value(path, name, known);
    return PresetSource<T>::get(name);
  }
};

/// The documentation of an option struct, from the same listing.
/// Defaults are those of `options`: a struct may give its members others than their type has.
template <Listed Options>
std::vector<OptionDoc> describe_options(const Options& options = {});

template <class T>
struct Describe {
  static void into(OptionDoc&) {}
};
template <NamedEnum E>
struct Describe<E> {
  static void into(OptionDoc& doc) { doc.values = enum_names<E>(); }
};
template <Listed Options>
struct Describe<Options> {
  static void into(OptionDoc& doc) { doc.options = describe_options<Options>(); }
};
template <class T>
struct Describe<std::optional<T>> : Describe<T> {};
template <class T>
struct Describe<std::vector<T>> : Describe<T> {};
template <class T>
struct Describe<Required<T>> : Describe<T> {};
template <class T>
struct Describe<Preset<T>> {
  static void into(OptionDoc& doc) {
    doc.values = PresetSource<T>::names();
    doc.options = describe_options<T>();
    const std::string text = "the named set that the other keys change";
    doc.options.insert(doc.options.begin(), {.name = "preset", .type = "name", .text = text, .values = doc.values});
  }
};

template <class T>
std::string standard_text(const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    return value ? "true" : "false";
  else if constexpr (NamedEnum<T>)
    return std::string("'") + to_string(value) + "'";
  else if constexpr (std::is_floating_point_v<T>)
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string();
  else if constexpr (std::is_integral_v<T>)
    return fmt::format("{}", value);
  else
    return {};
}

template <Listed Options>
std::vector<OptionDoc> describe_options(const Options& options) {
  std::vector<OptionDoc> docs;
  fields(options, [&](const Field& field, const auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    OptionDoc doc{.name = field.name,
                  .type = Lua<typename OptionTraits<Member>::Value>::type(),
                  .unit = field.unit,
                  .text = field.doc,
                  .standard = standard_text(member),
                  .required = OptionTraits<Member>::required};
    if constexpr (Listed<Member>)
      doc.options = describe_options(member);
    else
      Describe<Member>::into(doc);
    docs.push_back(std::move(doc));
  });
  return docs;
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "base/names.hpp"

namespace meander {

/// Describes one option. An option struct lists its members once, in a free function found by argument lookup:
///
///   template <class Options, class Visitor>
///     requires std::same_as<std::remove_const_t<Options>, DriftOptions>
///   void fields(Options& o, Visitor&& visit) {
///     visit(Field{"distance", "m/m", "systematic error of distances", -0.5, 0.5}, o.distance);
///   }
///
/// From that one list come reading a Lua table, help(), the reference page, record headers and validate().
struct Field {
  const char* name;
  const char* unit;  ///< SI unit, "" for none
  const char* doc;   ///< one sentence without the final stop
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// The strings of an enumeration: specialise with a constexpr `entries` array of {value, "name"}.
template <class E>
struct EnumNames;

template <class E>
concept NamedEnum = std::is_enum_v<E> && requires {
  EnumNames<E>::entries;
};

template <NamedEnum E>
std::vector<std::string> enum_names() {
  std::vector<std::string> names;
  for (const auto& [value, name] : EnumNames<E>::entries) names.emplace_back(name);
  return names;
}

template <NamedEnum E>
const char* to_string(E value) {
  for (const auto& [candidate, name] : EnumNames<E>::entries)
    if (candidate == value) return name;
  return "?";
}

template <NamedEnum E>
std::optional<E> enum_from(std::string_view text) {
  for (const auto& [value, name] : EnumNames<E>::entries)
    if (text == name) return value;
  return std::nullopt;
}

/// Takes any member: what `Listed` asks fields() to be called with.
struct AnyVisitor {
  template <class Member>
  void operator()(const Field&, Member&) const {}
};

/// A struct whose members are listed by a fields() function.
template <class T>
concept Listed = requires(T& t) {
  fields(t, AnyVisitor{});
};

/// The names of all options of `Options`, in listing order.
template <Listed Options>
std::vector<std::string> field_names() {
  std::vector<std::string> names;
  Options options{};
  fields(options, [&](const Field& field, auto&) { names.emplace_back(field.name); });
  return names;
}

/// Throws ArgumentError "option 'name': number from a to b expected, got v" at the first value that is not finite or
/// out of its range. `where` (may be empty) goes in front of nested option names: "sonar.".
template <Listed Options>
void validate(const Options& options, const std::string& where = {}) {
  fields(options, [&](const Field& field, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (Listed<T>) {
      validate(value, where + field.name + ".");
    } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      const double number = static_cast<double>(value);
      if (!(number >= field.least && number <= field.most) || !std::isfinite(number))
        fail("option '{}{}': {}{} expected, got {}", where, field.name,
             std::isinf(field.most) ? (std::isinf(field.least) ? std::string("a finite number")
                                                               : fmt::format("a number >= {}", field.least))
                                    : fmt::format("a number from {} to {}", field.least, field.most),
             *field.unit ? fmt::format(" [{}]", field.unit) : std::string(), value);
    }
  });
}

}  // namespace meander

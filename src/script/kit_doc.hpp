// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string_view>

#include "script/kit_call.hpp"
#include "script/kit_options.hpp"

namespace meander::script {

/// One argument in words; its type is known from the C++ function.
struct Arg {
  const char* name = nullptr;
  const char* text = nullptr;
  const char* unit = "";
};

/// The documentation record as it is written beside a binding. All but `errors` (and `args`, `returns` where there are
/// none) must be there, or the program does not compile.
struct Doc {
  static constexpr std::size_t kMostArgs = 6;
  const char* name = nullptr;
  const char* text = nullptr;
  Arg args[kMostArgs] = {};
  const char* returns = nullptr;       ///< in words
  const char* returns_type = nullptr;  ///< where the C++ type tells too little: "run or list of run"
  const char* errors = "";             ///< what makes the call fail
  const char* example = nullptr;       ///< runs as it stands
};

/// The record of a property.
struct PropertyDoc {
  const char* name = nullptr;
  const char* text = nullptr;
  const char* unit = "";
  const char* example = nullptr;
};

constexpr bool written(const char* text) { return text && *text; }

/// Is the record complete for a function with so many arguments (self not counted)?
constexpr bool complete(const Doc& doc, std::size_t arguments, bool returns) {
  if (!written(doc.name) || !written(doc.text) || !written(doc.example)) return false;
  if (returns != written(doc.returns) || arguments > Doc::kMostArgs) return false;
  for (std::size_t i = 0; i < Doc::kMostArgs; ++i)
    if ((i < arguments) != (written(doc.args[i].name) && written(doc.args[i].text))) return false;
  return true;
}

/// Named in the compiler's message when a binding's record is not complete.
inline void documentation_record_is_incomplete() {}

template <std::size_t arguments, bool returns>
struct CompleteDoc {
  Doc doc;
  consteval CompleteDoc(const Doc& written) : doc(written) {  // NOLINT: conversion is the point
    if (!complete(written, arguments, returns)) documentation_record_is_incomplete();
  }
};

struct CompletePropertyDoc {
  PropertyDoc doc;
  consteval CompletePropertyDoc(const PropertyDoc& given) : doc(given) {  // NOLINT: conversion is the point
    if (!written(given.name) || !written(given.text) || !written(given.example)) documentation_record_is_incomplete();
  }
};

namespace detail {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// May the argument be left out? Yes for optional ones and for option tables that need no key.
template <class T>
bool may_be_left_out(const std::vector<OptionDoc>& options) {
  if (is_optional<T>) return true;
  if (!Listed<T>) return false;
  return std::none_of(options.begin(), options.end(), [](const OptionDoc& option) { return option.required; });
}

template <class P>
void describe_argument(const Doc& doc, std::size_t& next, std::vector<ArgumentDoc>& out) {
  if constexpr (Parameter<P>::from_lua) {
    using T = std::remove_cvref_t<P>;
    const Arg& arg = doc.args[next++];
    OptionDoc described;
    Describe<T>::into(described);
    const bool optional = may_be_left_out<T>(described.options);
    out.push_back({arg.name, Lua<T>::type(), arg.unit, arg.text, optional, described.values, described.options});
  }
}

template <class Arguments, bool is_method>
std::vector<ArgumentDoc> describe_arguments(const Doc& doc) {
  std::vector<ArgumentDoc> result;
  std::size_t next = 0;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (describe_argument<std::tuple_element_t<I + is_method, Arguments>>(doc, next, result), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Arguments> - is_method>{});
  return result;
}

}  // namespace detail

/// What a result of type R is called: an empty optional is nil for Lua.
template <class R>
struct ResultType {
  static std::string text() { return Lua<R>::type(); }
};
template <class T>
struct ResultType<std::optional<T>> {
  static std::string text() { return ResultType<T>::text() + " or nil"; }
};
template <class... T>
struct ResultType<std::tuple<T...>> {
  static std::string text() {
    std::string all;
    ((all += (all.empty() ? "" : ", ") + ResultType<T>::text()), ...);
    return all;
  }
};

/// The record of a bound function for help() and the rest.
template <auto F, bool is_method>
Record make_record(const Doc& doc, const char* owner) {
  using R = std::remove_cvref_t<typename SignatureOf<F>::Result>;
  Record record{.kind = is_method ? DocKind::method : DocKind::function,
                .owner = owner,
                .member = doc.name,
                .text = doc.text,
                .arguments = detail::describe_arguments<typename SignatureOf<F>::Arguments, is_method>(doc),
                .errors = doc.errors,
                .example = doc.example};
  if constexpr (returns_something<F>) {
    record.returns = doc.returns;
    record.returns_type = written(doc.returns_type) ? doc.returns_type : ResultType<R>::text();
  }
  return record;
}

template <>
struct Lua<Pushed> {
  static std::string type() { return "any"; }
};

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"
#include "base/text_lines.hpp"

namespace meander {

/// Options as lines "option NAME VALUE", those of a struct within as NAME.NAME. Texts are left out: no option here that
/// decides anything is one.
template <Listed Options>
std::string option_lines(const Options& options, const std::string& where = {}) {
  std::string text;
  fields(options, [&](const Field& field, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    const std::string name = where + field.name;
    if constexpr (Listed<T>)
      text += option_lines(value, name + ".");
    else if constexpr (NamedEnum<T>)
      text += fmt::format("option {} {}\n", name, to_string(value));
    else if constexpr (!std::is_same_v<T, std::string>)
      text += fmt::format("option {} {}\n", name, value);
  });
  return text;
}

template <class T>
void read_option(const TextLines& lines, T& value) {
  if constexpr (NamedEnum<T>) {
    const auto known = enum_from<T>(lines.words()[2]);
    if (!known) lines.wrong("unknown value '{}', one of {} expected", lines.shown(2), listing(enum_names<T>()));
    value = *known;
  } else if constexpr (std::is_floating_point_v<T>) {
    value = lines.number(2);
  } else {
    value = lines.integer<T>(2, 0, std::numeric_limits<T>::max());
  }
}

/// Reads what option_lines wrote, all of it, in the same order. Does not ask whether numbers are in range.
template <Listed Options>
void read_option_lines(TextLines& lines, Options& options, const std::string& where = {}) {
  fields(options, [&](const Field& field, auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    const std::string name = where + field.name;
    if constexpr (Listed<T>) {
      read_option_lines(lines, value, name + ".");
    } else if constexpr (!std::is_same_v<T, std::string>) {
      if (!lines.next() || !lines.is("option") || lines.words().size() != 3 || lines.words()[1] != name)
        lines.wrong("'option {} VALUE' expected", name);
      read_option(lines, value);
    }
  });
}

/// Fails at the line that was read last unless all numbers are in range.
template <Listed Options>
void check_options(const TextLines& lines, const Options& options) {
  try {
    validate(options);
  } catch (const ArgumentError& error) {
    lines.wrong("{}", error.what());
  }
}

}  // namespace meander

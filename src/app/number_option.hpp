// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <string>
#include <type_traits>

namespace meander {

/// A check of the word behind an option that takes a number: "a number from 16 to 1e+06 [MiB] expected, got 'abc'".
template <class T>
auto number_from(T least, T most, const char* unit = "") {
  return [=](const std::string& word) -> std::string {
    T value{};
    const bool below = std::is_unsigned_v<T> && word.starts_with('-');  // the parser would wrap it round
    if (!below && CLI::detail::lexical_cast(word, value) && value >= least && value <= most) return {};
    const bool open = most == std::numeric_limits<T>::max();
    return fmt::format("a {}number from {:g} {}{}{} expected, got '{}'", std::is_integral_v<T> ? "whole " : "",
                       static_cast<double>(least), open ? "on" : fmt::format("to {:g}", static_cast<double>(most)),
                       *unit ? " " : "", *unit ? fmt::format("[{}]", unit) : "", word);
  };
}

}  // namespace meander

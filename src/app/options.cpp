// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "base/names.hpp"

namespace meander {
namespace {

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

}  // namespace

template <class T>
WordCheck number_from(T least, T most, const char* unit) {
  return [=](const std::string& word) -> std::string {
    T value{};
    const bool below = std::is_unsigned_v<T> && word.starts_with('-');  // the parser would wrap it round
    if (!below && CLI::detail::lexical_cast(word, value) && value >= least && value <= most) return {};
    const bool open = most == std::numeric_limits<T>::max();
    return fmt::format("a {}number from {:g} {}{} expected, got '{}'", std::is_integral_v<T> ? "whole " : "",
                       static_cast<double>(least), open ? "on" : fmt::format("to {:g}", static_cast<double>(most)),
                       *unit ? fmt::format(" [{}]", unit) : "", word);
  };
}
template WordCheck number_from(int, int, const char*);
template WordCheck number_from(std::uint64_t, std::uint64_t, const char*);
template WordCheck number_from(double, double, const char*);

void add_sandbox_options(CLI::App& app, std::optional<script::SandboxOptions>& sandbox) {
  const auto wanted = [&sandbox]() -> script::SandboxOptions& { return sandbox ? *sandbox : sandbox.emplace(); };
  app.add_flag_callback("--sandbox", wanted, "run a script of somebody else within limits");
  script::SandboxOptions standard;
  fields(standard, [&]<class T>(const Field& field, const T& value) {
    const auto set = [wanted, name = std::string_view(field.name)](const T& given) {
      fields(wanted(), [&]<class U>(const Field& other, U& member) {
        if constexpr (std::is_same_v<T, U>)
          if (name == other.name) member = given;
      });
    };
    const std::string unit = *field.unit ? fmt::format(" [{}]", field.unit) : "";
    CLI::Option* option = app.add_option_function<T>(fmt::format("--sandbox-{}", field.name), set, field.doc + unit)
                              ->default_str(fmt::format("{}", value))
                              ->take_last();
    if constexpr (std::is_arithmetic_v<T>)
      option->check(number_from(static_cast<T>(field.least), static_cast<T>(field.most), field.unit));
  });
}

std::string problem_of(const CLI::App& app, const std::exception& error) {
  const std::string text = error.what();
  const std::string name = text.substr(0, text.find(':'));
  const CLI::Option* option = app.get_option_no_throw(name);
  if (!option || !name.starts_with('-')) return text;
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
    return fmt::format("option {} needs a value: {} {}", name, name, option->get_type_name());
  return dynamic_cast<const CLI::ParseError*>(&error) ? "option " + text : text;
}

std::string unknown_option(const CLI::App& app, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const std::string hint = name.size() > 2 ? did_you_mean(name, option_names(app)) : std::string();
  return fmt::format("unknown option '{}'{}", name, hint);
}

}  // namespace meander

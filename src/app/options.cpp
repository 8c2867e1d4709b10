// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
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
    app.add_option_function<T>(fmt::format("--sandbox-{}", field.name), set, field.doc + unit)
        ->default_str(fmt::format("{}", value))
        ->take_last();
  });
}

std::string unknown_option(const CLI::App& app, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const std::string hint = name.size() > 2 ? did_you_mean(name, option_names(app)) : std::string();
  return fmt::format("unknown option '{}'{}", name, hint);
}

}  // namespace meander

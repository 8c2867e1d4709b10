// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string_view>

#include "app/subcommands.hpp"
#include "base/names.hpp"

namespace meander {
namespace {

constexpr const char* kFooter = R"(
FILE and everything behind it belong to the script: its arguments are in the table 'arg' and in '...'. A lone - reads the
script from standard input, and so does a call without FILE when standard input is not a terminal.

Exit codes: 0 done, 1 error in a script, 2 error on the command line, 130 interrupted.)";

struct Formatter : CLI::Formatter {
  std::string make_usage(const CLI::App*, std::string) const override {
    std::string text =
        "Usage: meander [OPTIONS] [FILE [ARGUMENTS...]]\n"
        "Without FILE and -e: the prompt. In a checkout, ./meander test runs the test suite.\n"
        "\nCommands, each with --help:\n";
    for (const Subcommand& command : subcommands())
      text += fmt::format("  meander {:<20} {}\n", fmt::format("{} {}", command.name, command.arguments), command.text);
    return text;
  }
};

int usage_error(const std::string& message) {
  fmt::print(stderr, "meander: {} (meander --help tells more)\n", message);
  return kExitUsage;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// What stands behind the options: the script and its arguments, or something that looked like an option.
std::optional<int> take_script(const CLI::App& app, std::vector<std::string> rest, CommandLine& line) {
  const bool separated = !rest.empty() && rest[0] == "--";
  if (separated) rest.erase(rest.begin());
  if (rest.empty()) return std::nullopt;
  if (!separated && rest[0].size() > 1 && rest[0][0] == '-') {
    const std::string name = rest[0].substr(0, rest[0].find('='));
    const std::string hint = name.size() > 2 ? did_you_mean(name, option_names(app)) : std::string();
    return usage_error(fmt::format("unknown option '{}'{}", name, hint));
  }
  line.script = rest[0];
  line.arguments.assign(rest.begin() + 1, rest.end());
  return std::nullopt;
}

/// --sandbox, and --sandbox-NAME for each of its limits, which imply it.
void add_sandbox_options(CLI::App& app, CommandLine& line) {
  const auto wanted = [&line]() -> script::SandboxOptions& {
    return line.sandbox ? *line.sandbox : line.sandbox.emplace();
  };
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
        ->default_str(fmt::format("{}", value));
  });
}

}  // namespace

std::optional<int> parse_command_line(int argc, char** argv, CommandLine& line) {
  CLI::App app("meander: a laboratory for sonar navigation in a terminal", "meander");
  app.formatter(std::make_shared<Formatter>());
  app.footer(kFooter);
  app.set_help_flag("-h,--help", "this text");
  app.set_version_flag("--version", "meander " MEANDER_VERSION, "the version");
  app.add_option("-e", line.code, "run CODE; may be repeated")->type_name("CODE")->allow_extra_args(false);
  app.add_option("-l", line.modules, "require MODULE before anything else; may be repeated")
      ->type_name("MODULE")
      ->allow_extra_args(false);
  app.add_flag("-i", line.interactive, "the prompt, after everything else");
  app.add_flag("--no-rc", line.no_rc, "at the prompt, skip the start-up file $XDG_CONFIG_HOME/meander/init.lua");
  app.add_option("--lua-dir", line.lua_dir, "use the Lua modules of DIR instead of those inside the program")
      ->type_name("DIR");
  add_sandbox_options(app, line);
  app.prefix_command();
  try {
    app.parse(argc, argv);
    if (line.sandbox) validate(*line.sandbox, "--sandbox-");
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const std::exception& error) {
    return usage_error(error.what());
  }
  return take_script(app, app.remaining(), line);
}

}  // namespace meander

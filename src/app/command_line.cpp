// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "app/options.hpp"
#include "app/subcommands.hpp"

namespace meander {
namespace {

constexpr const char* kFooter = R"(
FILE and everything behind it belong to the script: its arguments are in the table 'arg' and in '...'. A lone - reads the
script from standard input, and so does a call without FILE when standard input is not a terminal.

Exit codes: )";

constexpr std::array kExitCodes = {
    ExitCode{kExitOk, "done"},
    ExitCode{kExitScriptError, "error in a script"},
    ExitCode{kExitUsage, "error on the command line"},
    ExitCode{kExitTestFailed, "a test failed"},
    ExitCode{kExitInterrupted, "interrupted"},
};

std::string footer() {
  std::string text;
  for (const ExitCode& code : kExitCodes)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", code.code, code.text);
  return kFooter + text + ".";
}

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

/// What stands behind the options: the script and its arguments, or something that looked like an option.
std::optional<int> take_script(const CLI::App& app, std::vector<std::string> rest, CommandLine& line) {
  const bool separated = !rest.empty() && rest[0] == "--";
  if (separated) rest.erase(rest.begin());
  if (rest.empty()) return std::nullopt;
  if (!separated && rest[0].size() > 1 && rest[0][0] == '-') return usage_error(unknown_option(app, rest[0]));
  line.script = rest[0];
  line.arguments.assign(rest.begin() + 1, rest.end());
  return std::nullopt;
}

void add_options(CLI::App& app, CommandLine& line) {
  app.formatter(std::make_shared<Formatter>());
  app.footer(footer());
  app.set_help_flag("-h,--help", "this text");
  app.set_version_flag("--version", "meander " MEANDER_VERSION, "the version");
  app.add_option("-e", line.code, "run CODE; may be repeated")->type_name("CODE")->allow_extra_args(false);
  app.add_option("-l", line.modules, "require MODULE before anything else; may be repeated")
      ->type_name("MODULE")
      ->allow_extra_args(false);
  app.add_flag("-i", line.interactive, "the prompt, after everything else");
  app.add_flag("--no-rc", line.no_rc, "at the prompt, skip the start-up file $XDG_CONFIG_HOME/meander/init.lua");
  app.add_option("--lua-dir", line.lua_dir, "use the Lua modules of DIR instead of those inside the program")
      ->type_name("DIR")
      ->check([](const std::string& path) {
        std::error_code failed;
        return std::filesystem::is_directory(path, failed) ? std::string() : "no folder '" + path + "'";
      });
  add_sandbox_options(app, line.sandbox);
  app.prefix_command();
}

}  // namespace

std::span<const ExitCode> exit_codes() { return kExitCodes; }

std::vector<OptionText> option_texts() {
  CommandLine line;
  CLI::App app;
  add_options(app, line);
  std::vector<OptionText> texts;
  for (const CLI::Option* option : app.get_options()) {
    std::string form = option->get_name(false, true);
    for (std::size_t at = form.find(','); at != std::string::npos; at = form.find(',', at + 2))
      form.insert(at + 1, " ");
    if (!option->get_type_name().empty()) form += " " + option->get_type_name();
    const std::string standard = option->get_default_str();
    texts.push_back({form, option->get_description() + (standard.empty() ? "" : " (" + standard + ")")});
  }
  return texts;
}

std::optional<int> parse_command_line(int argc, char** argv, CommandLine& line) {
  CLI::App app("meander: a laboratory for sonar navigation in a terminal", "meander");
  add_options(app, line);
  try {
    app.parse(argc, argv);
    if (line.sandbox) validate(*line.sandbox, "--sandbox-");
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const std::exception& error) {
    return usage_error(problem_of(app, error));
  }
  return take_script(app, app.remaining(), line);
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>

#include "app/man_page.hpp"
#include "app/options.hpp"
#include "app/output.hpp"
#include "app/subcommands.hpp"
#include "base/atomic_file.hpp"
#include "base/names.hpp"
#include "base/text_file.hpp"
#include "script/help_text.hpp"
#include "script/interpreter.hpp"
#include "script/luals_stubs.hpp"
#include "script/reference_text.hpp"
#include "script/terminal_device.hpp"
#include "script/wrapped_text.hpp"

namespace meander {
namespace {

using script::Docs;
using script::Record;

constexpr const char* kFooter = R"(
NAME is what help() takes: meander.sim.new, sim:drive, world, show. Without it: what there is.

Exit codes: 0 done, 1 a file cannot be written, 2 error on the command line or unknown name, 3 --check found a difference.)";

/// What is generated from the records, and where a checkout keeps it.
struct Generated {
  const char* flag;
  const char* text;
  const char* path;
  std::string (*make)(const Docs& docs);
};
constexpr std::array kGenerated = {
    Generated{"--markdown", "print the reference page in Markdown", "docs/reference.md", script::reference_text},
    Generated{"--luals", "print annotations for the Lua language server", "lua/meta/meander.lua", script::luals_stubs},
    Generated{"--man", "print the manual page, in roff", "docs/meander.1", man_page},
};

struct DocOptions {
  std::string name;
  std::string out;
  std::vector<const Generated*> wanted;
  bool write = false;
  bool check = false;
};

int usage_error(const std::string& message) {
  complain(message + " (meander doc --help tells more)");
  return kExitUsage;
}

void add_options(CLI::App& app, DocOptions& options) {
  app.set_help_flag("-h,--help", "this text");
  for (const Generated& generated : kGenerated)
    app.add_flag_callback(
        generated.flag, [&options, &generated] { options.wanted.push_back(&generated); }, generated.text);
  app.add_option("--out", options.out, "write to FILE instead of standard output")->type_name("FILE");
  app.add_flag("--write", options.write, "in a checkout: write all generated files anew");
  app.add_flag("--check", options.check, "in a checkout: are all generated files as --write would write them?");
  app.add_option("NAME", options.name, "what to tell about")->type_name("");
}

std::optional<int> parse(const CommandLine& line, DocOptions& options) {
  CLI::App app("meander doc: tells what scripts see", "meander doc");
  app.footer(kFooter);
  app.allow_extras();
  add_options(app, options);
  try {
    app.parse(std::vector<std::string>(line.arguments.rbegin(), line.arguments.rend()));  // CLI11 wants them so
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return usage_error(problem_of(app, error));
  }
  if (options.wanted.size() + options.write + options.check + !options.name.empty() > 1)
    return usage_error("one of NAME, --markdown, --luals, --man, --write and --check expected, got several");
  for (const std::string& word : app.remaining())
    return usage_error(word[0] == '-' ? unknown_option(app, word) : "one NAME expected, got '" + word + "' too");
  return std::nullopt;
}

int deliver(const std::string& text, const DocOptions& options) {
  if (options.out.empty())
    fmt::print("{}", text);
  else
    write_file_atomically(options.out, text);
  return kExitOk;
}

std::string text_of(const char* path) {
  constexpr std::size_t kMost = 64u << 20;
  return std::filesystem::exists(path) ? read_text_file(path, kMost) : std::string();
}

/// --write and --check.
int update(const Docs& docs, bool write) {
  int code = kExitOk;
  for (const Generated& generated : kGenerated) {
    const std::filesystem::path path = generated.path;
    if (!std::filesystem::is_directory(path.parent_path()))
      return usage_error("no folder '" + path.parent_path().string() + "' here: the root of a checkout expected");
    const std::string text = generated.make(docs);
    if (text == text_of(generated.path)) continue;
    if (write) {
      write_file_atomically(generated.path, text);
      fmt::print("{}\n", generated.path);
    } else {
      complain(fmt::format("{} is not what the records say; ./meander doc --write writes it anew", generated.path));
      code = kExitTestFailed;
    }
  }
  return code;
}

int tell(const Docs& docs, const DocOptions& options) {
  const std::size_t width = options.out.empty() ? script::text_width() : 0;
  if (options.name.empty()) return deliver(script::wrapped(overview_text(docs), width), options);
  const Record* record = find_record(docs, options.name);
  if (record) return deliver(help_text(docs, *record, width), options);
  complain("nothing is known about '" + options.name + "'" + did_you_mean(options.name, record_names(docs)));
  return kExitUsage;
}

}  // namespace

int doc_command(const CommandLine& line) {
  DocOptions options;
  if (const auto code = parse(line, options)) return *code;
  script::Interpreter lua({.lua_dir = line.lua_dir});
  const Docs& docs = lua.session().docs;
  if (options.write || options.check) return update(docs, options.write);
  return options.wanted.empty() ? tell(docs, options) : deliver(options.wanted[0]->make(docs), options);
}

}  // namespace meander

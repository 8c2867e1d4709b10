// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/reference_text.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>

#include "script/example_lines.hpp"
#include "script/help_text.hpp"

namespace meander::script {
namespace {

constexpr const char* kHead = R"(# Reference

Every name that scripts see: its arguments, results, errors and an example that runs as it stands. The same text is in
`help(x)`. Lengths are metres, times seconds, angles radians counter-clockwise from the x axis.

A function whose only argument is a table of options is written `f { options }`; a question mark means that an argument may
be left out. At the prompt, modules are also there without `meander.` in front.

This page is written by `meander doc --write`; changes here are lost.

)";

/// GitHub's name of a heading in links: lower case, blanks as hyphens, no punctuation.
std::string anchor(std::string_view heading) {
  std::string result;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || c == '_' || c == '-') result += static_cast<char>(std::tolower(byte));
    if (c == ' ') result += '-';
  }
  return result;
}

std::string link(const std::string& shown, const std::string& heading) {
  return "[" + shown + "](#" + anchor(heading) + ")";
}

/// Prose in which Markdown must find no marks of its own; `|` would end a cell of a table.
std::string prose(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("*<>|`\\").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

/// Code in a cell of a table.
std::string cell_code(std::string_view text) {
  if (text.empty()) return {};
  std::string result;
  for (const char c : text) result += c == '|' ? "\\|" : std::string(1, c);
  return "`" + result + "`";
}

std::string standard_of(const OptionDoc& option) {
  return option.required ? "must be given" : cell_code(option.standard);
}
std::string standard_of(const ArgumentDoc& argument) { return argument.optional ? "may be left out" : "must be given"; }

template <class Documented>
std::string row(const Documented& doc, const std::string& more) {
  return fmt::format("| `{}` | {} | {} | {} | {}{} |\n", doc.name, cell_code(type_in_words(doc.type, doc.values)),
                     prose(doc.unit), standard_of(doc), prose(doc.text), more);
}

/// A table of options and, behind it, those of its keys that are tables; `shown` maps what was told to where.
void add_options(std::string& text, const std::vector<OptionDoc>& options, const std::string& path,
                 std::set<std::string>& shown) {
  text += "\n| key | type | unit | when left out | meaning |\n|---|---|---|---|---|\n";
  std::vector<const OptionDoc*> tables;
  for (const OptionDoc& option : options) {
    const bool table = !option.options.empty();
    const bool again = table && !shown.insert(shape_of(option)).second;
    if (table && !again) tables.push_back(&option);
    text += row(option, again ? "; its keys as above" : table ? "; its keys below" : "");
  }
  for (const OptionDoc* option : tables) {
    const std::string inner = path + option->name;
    text += fmt::format("\nKeys of `{}`, {}:\n", inner, prose(option->text));
    add_options(text, option->options, inner + ".", shown);
  }
}

void add_arguments(std::string& text, const Record& record) {
  std::set<std::string> shown;
  if (record.takes_options()) {
    text += fmt::format("\nOptions: {}.\n", prose(record.arguments[0].text));
    return add_options(text, record.arguments[0].options, "", shown);
  }
  if (record.arguments.empty()) return;
  text += "\n| argument | type | unit | | meaning |\n|---|---|---|---|---|\n";
  for (const ArgumentDoc& argument : record.arguments) text += row(argument, "");
  for (const ArgumentDoc& argument : record.arguments) {
    if (argument.options.empty()) continue;
    text += fmt::format("\nKeys of `{}`:\n", argument.name);
    add_options(text, argument.options, "", shown);
  }
}

/// "number [m], can be set"
std::string property_note(const Record& record) {
  return "`" + record.returns_type + "`" + (record.returns.empty() ? "" : " [" + prose(record.returns) + "]") +
         (record.settable ? ", can be set" : "");
}

void add_entry(std::string& text, const Record& record) {
  text += "\n### " + record.name() + "\n\n";
  const bool property = record.kind == DocKind::property;
  if (property)
    text += property_note(record);
  else
    text += "`" + record.signature() + "`" + (record.returns_type.empty() ? "" : " → `" + record.returns_type + "`");
  text += "\n\n" + prose(record.text) + "\n";
  add_arguments(text, record);
  if (!property && !record.returns.empty()) text += "\nReturns " + prose(record.returns) + ".\n";
  if (!record.errors.empty()) text += "\nFails on " + prose(record.errors) + ".\n";
  text += "\n```lua\n" + example_lines(record.example) + "\n```\n";
}

/// A module or a type: its text, and an entry for each member that is no module.
struct Chapter {
  std::string title;
  std::string text;
  std::vector<const Record*> members;
};

std::vector<Chapter> chapters_of(const Docs& docs, DocKind kind) {
  std::vector<Chapter> chapters;
  for (const Record& record : docs.all()) {
    if (record.kind != kind) continue;
    Chapter chapter{record.name(), record.text, {}};
    for (const Record* member : docs.members(record.name()))
      if (member->kind != DocKind::module) chapter.members.push_back(member);
    chapters.push_back(std::move(chapter));
  }
  return chapters;
}

Chapter globals_of(const Docs& docs) {
  Chapter globals{"Globals", "Functions that are there without a module.", {}};
  for (const Record& record : docs.all())
    if (record.kind == DocKind::function && record.owner.empty()) globals.members.push_back(&record);
  return globals;
}

/// Objects and modules may have the same name: "sim" is an object, "meander.sim" a module.
std::string contents(const std::vector<Chapter>& chapters) {
  std::string text;
  for (const Chapter& chapter : chapters) {
    text += "- " + link(chapter.title, chapter.title) + (chapter.members.empty() ? "" : ": ");
    std::string separator;
    for (const Record* member : chapter.members) {
      text += separator + link(member->member, member->name());
      separator = ", ";
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string reference_text(const Docs& docs) {
  std::vector<Chapter> chapters = chapters_of(docs, DocKind::module);
  for (Chapter& type : chapters_of(docs, DocKind::type)) chapters.push_back(std::move(type));
  chapters.push_back(globals_of(docs));
  std::string text = kHead + contents(chapters);
  for (const Chapter& chapter : chapters) {
    text += "\n## " + chapter.title + "\n\n" + prose(chapter.text) + "\n";
    for (const Record* member : chapter.members) add_entry(text, *member);
  }
  return text;
}

}  // namespace meander::script

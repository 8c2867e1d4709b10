// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/help_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "script/example_lines.hpp"
#include "script/wrapped_text.hpp"

namespace meander::script {
namespace {

std::string quoted_list(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "'" : " | '") + value + "'";
  return text;
}

/// "number [m]", "'a' | 'b' or table of options".
std::string type_text(const std::string& type, const std::string& unit, const std::vector<std::string>& values) {
  return type_in_words(type, values) + (unit.empty() ? "" : " [" + unit + "]");
}

/// The keys of a nested table that are all among those beside it: ", a and b as above"; else nothing.
std::string keys_told_beside(const OptionDoc& option, const std::vector<OptionDoc>& beside) {
  std::string names;
  for (const OptionDoc& key : option.options) {
    const bool told = std::any_of(beside.begin(), beside.end(), [&](const OptionDoc& other) {
      return other.name == key.name && other.text == key.text;
    });
    if (!told) return {};
    names += (names.empty() ? "" : ", ") + key.name;
  }
  return names.empty() ? names : "; " + names + " as above";
}

/// Nested tables that were told already (`shown`) are not told again.
void append_options(std::string& text, const std::vector<OptionDoc>& options, const std::string& indent,
                    std::set<std::string>& shown) {
  std::size_t width = 0;
  for (const OptionDoc& option : options) width = std::max(width, option.name.size());
  for (const OptionDoc& option : options) {
    const std::string note = option.required           ? ", must be given"
                             : option.standard.empty() ? ""
                                                       : ", " + option.standard + " when left out";
    std::string above = keys_told_beside(option, options);
    if (above.empty() && !option.options.empty() && !shown.insert(shape_of(option)).second)
      above = "; its keys as above";
    text += fmt::format("{}{:<{}}  {}: {}{}{}\n", indent, option.name, width,
                        type_text(option.type, option.unit, option.values), option.text, note, above);
    if (above.empty()) append_options(text, option.options, indent + "  ", shown);
  }
}

void append_arguments(std::string& text, const std::vector<ArgumentDoc>& arguments) {
  std::set<std::string> shown;
  for (const ArgumentDoc& argument : arguments) {
    text += fmt::format("  {}{}  {}: {}\n", argument.name, argument.optional ? "?" : "",
                        type_text(argument.type, argument.unit, argument.values), argument.text);
    append_options(text, argument.options, "    ", shown);
  }
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// One line per option about the (lower-case) word, each name and text once.
void append_options_about(std::string& text, const std::vector<OptionDoc>& options, const std::string& prefix,
                          const std::string& word, std::set<std::string>& told) {
  for (const OptionDoc& option : options) {
    const std::string name = prefix + option.name;
    if (lower(option.name + "\n" + option.text).find(word) != std::string::npos &&
        told.insert(option.name + "\n" + option.text).second)
      text += fmt::format("      {}  {}\n", name, option.text);
    append_options_about(text, option.options, name + ".", word, told);
  }
}

std::size_t signature_width(const std::vector<const Record*>& records) {
  constexpr std::size_t kWidest = 36;
  std::size_t width = 0;
  for (const Record* record : records) width = std::max(width, std::min(kWidest, record->signature().size()));
  return width;
}

std::string record_line(const Record& record, std::size_t width) {
  return fmt::format("  {:<{}}  {}\n", record.signature(), width, record.text);
}

}  // namespace

std::string type_in_words(const std::string& type, const std::vector<std::string>& values) {
  constexpr std::string_view kName = "name";
  if (values.empty() || !type.starts_with(kName)) return type;
  return quoted_list(values) + type.substr(kName.size());
}

std::string shape_of(const OptionDoc& option) {
  std::string shape = option.name;
  for (const OptionDoc& inner : option.options) shape += " " + inner.name;
  return shape;
}

std::string list_text(const std::vector<const Record*>& records) {
  const std::size_t width = signature_width(records);
  std::string text;
  for (const Record* record : records) text += record_line(*record, width);
  return text;
}

std::string apropos_text(const Docs& docs, std::string_view word) {
  const std::string wanted = lower(word);
  std::vector<const Record*> found;
  std::vector<std::string> options;  // the lines below each of them
  for (const Record& record : docs.all()) {
    std::string lines;
    std::set<std::string> told;
    for (const ArgumentDoc& argument : record.arguments)
      append_options_about(lines, argument.options, "", wanted, told);
    if (lines.empty() && lower(record.name() + " " + record.text).find(wanted) == std::string::npos) continue;
    found.push_back(&record);
    options.push_back(std::move(lines));
  }
  std::string text;
  for (std::size_t i = 0; i < found.size(); ++i) text += record_line(*found[i], signature_width(found)) + options[i];
  return text;
}

std::string help_text(const Docs& docs, const Record& record, std::size_t width) {
  std::string text = record.signature();
  if (record.kind == DocKind::property) text += ": " + type_text(record.returns_type, record.returns, {});
  text += "\n  " + record.text + "\n";
  append_arguments(text, record.arguments);
  if (record.kind != DocKind::property && !record.returns_type.empty())
    text += fmt::format("  returns  {}: {}\n", record.returns_type, record.returns);
  if (record.settable) text += "  can be set\n";
  if (!record.errors.empty()) text += "  fails on  " + record.errors + "\n";
  if (record.kind == DocKind::module || record.kind == DocKind::type) text += list_text(docs.members(record.name()));
  text = wrapped(text, width);
  if (!record.example.empty()) text += "  example\n    " + indented(example_lines(record.example), "    ") + "\n";
  return text;
}

std::string overview_text(const Docs& docs) {
  std::vector<const Record*> functions, of_meander, modules, types;
  for (const Record& record : docs.all()) {
    if (record.kind == DocKind::module) modules.push_back(&record);
    if (record.kind == DocKind::type) types.push_back(&record);
    if (record.kind == DocKind::function && record.owner.empty()) functions.push_back(&record);
    if (record.kind == DocKind::function && record.owner == "meander") of_meander.push_back(&record);
  }
  functions.insert(functions.end(), of_meander.begin(), of_meander.end());
  return "functions\n" + list_text(functions) + "modules\n" + list_text(modules) + "objects\n" + list_text(types) +
         "help(x) tells more about a function, module, object or name: help 'sim:drive'.\n"
         "apropos(word) finds names. The folder examples has whole scripts.\n"
         "In a shell 'meander test' runs scripted tests and 'meander doc' tells the same.\n";
}

const Record* find_record(const Docs& docs, std::string_view name) {
  const Record* record = docs.find(name);
  const Record* of_module = docs.find("meander." + std::string(name));
  const bool method_with_dot = record && record->kind == DocKind::method && name.find(':') == std::string_view::npos;
  return of_module && (!record || method_with_dot) ? of_module : record;  // at the prompt modules are plain names
}

std::vector<std::string> record_names(const Docs& docs) {
  std::vector<std::string> names;
  for (const Record& record : docs.all()) names.push_back(record.name());
  return names;
}

}  // namespace meander::script

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/help_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meander::script {
namespace {

std::string quoted_list(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "'" : " | '") + value + "'";
  return text;
}

/// "number [m]", "'a' | 'b', or table of options".
std::string type_text(const std::string& type, const std::string& unit, const std::vector<std::string>& values) {
  const bool plain = values.empty() || type.find('\'') != std::string::npos;
  return (plain ? type : quoted_list(values) + ", or table of options") + (unit.empty() ? "" : " [" + unit + "]");
}

void append_options(std::string& text, const std::vector<OptionDoc>& options, const std::string& indent) {
  std::size_t width = 0;
  for (const OptionDoc& option : options) width = std::max(width, option.name.size());
  for (const OptionDoc& option : options) {
    const std::string note = option.required           ? ", must be given"
                             : option.standard.empty() ? ""
                                                       : ", " + option.standard + " when left out";
    text += fmt::format("{}{:<{}}  {}: {}{}\n", indent, option.name, width,
                        type_text(option.type, option.unit, option.values), option.text, note);
    append_options(text, option.options, indent + "  ");
  }
}

void append_arguments(std::string& text, const std::vector<ArgumentDoc>& arguments) {
  for (const ArgumentDoc& argument : arguments) {
    text += fmt::format("  {}{}  {}: {}\n", argument.name, argument.optional ? "?" : "",
                        type_text(argument.type, argument.unit, argument.values), argument.text);
    append_options(text, argument.options, "    ");
  }
}

}  // namespace

std::string list_text(const std::vector<const Record*>& records) {
  constexpr std::size_t kWidest = 36;
  std::size_t width = 0;
  for (const Record* record : records) width = std::max(width, std::min(kWidest, record->signature().size()));
  std::string text;
  for (const Record* record : records) text += fmt::format("  {:<{}}  {}\n", record->signature(), width, record->text);
  return text;
}

std::string help_text(const Docs& docs, const Record& record) {
  std::string text = record.signature();
  if (record.kind == DocKind::property) text += ": " + type_text(record.returns_type, record.returns, {});
  text += "\n  " + record.text + "\n";
  append_arguments(text, record.arguments);
  if (record.kind != DocKind::property && !record.returns_type.empty())
    text += fmt::format("  returns  {}: {}\n", record.returns_type, record.returns);
  if (record.settable) text += "  can be set\n";
  if (!record.errors.empty()) text += "  fails on  " + record.errors + "\n";
  if (record.kind == DocKind::module || record.kind == DocKind::type) text += list_text(docs.members(record.name()));
  if (!record.example.empty()) text += "  example  " + record.example + "\n";
  return text;
}

std::string overview_text(const Docs& docs) {
  std::vector<const Record*> functions, modules, types;
  for (const Record& record : docs.all()) {
    if (record.kind == DocKind::module) modules.push_back(&record);
    if (record.kind == DocKind::type) types.push_back(&record);
    if (record.kind == DocKind::function && record.owner.empty()) functions.push_back(&record);
  }
  return "functions\n" + list_text(functions) + "modules\n" + list_text(modules) + "objects\n" + list_text(types) +
         "help(x) tells more about a function, module, object or name, apropos(word) finds names.\n";
}

const Record* find_record(const Docs& docs, std::string_view name) {
  const Record* record = docs.find(name);
  return record ? record : docs.find("meander." + std::string(name));
}

std::vector<std::string> record_names(const Docs& docs) {
  std::vector<std::string> names;
  for (const Record& record : docs.all()) names.push_back(record.name());
  return names;
}

}  // namespace meander::script

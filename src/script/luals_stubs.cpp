// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/luals_stubs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "script/example_lines.hpp"
#include "script/type_annotation.hpp"

namespace meander::script {
namespace {

constexpr const char* kHead = R"(-- SPDX-License-Identifier: GPL-3.0-or-later
-- SPDX-FileCopyrightText: the meander authors
---@meta meander
-- What scripts see of meander, for the Lua language server. Written by `meander doc --write`; changes here are lost.

)";

std::string comment(std::string_view text) { return "---" + indented(text, "---") + "\n"; }

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " [" + unit + "]";
}

std::string identifier(const std::string& name) {
  constexpr std::array<std::string_view, 6> kTaken = {"end", "function", "repeat", "until", "in", "not"};
  return std::find(kTaken.begin(), kTaken.end(), name) == kTaken.end() ? name : name + "_";
}

/// Tells tables of options apart by everything that is said about their keys.
std::string shape_of(const std::vector<OptionDoc>& options) {
  std::string shape;
  for (const OptionDoc& option : options)
    shape += fmt::format("{}\n{}\n{}\n{}\n({})", option.name, option.type, option.text, option.standard,
                         shape_of(option.options));
  return shape;
}

class Stubs {
 public:
  explicit Stubs(const Docs& docs) : docs_(docs) {}

  std::string run() {
    text_ = kHead + point_classes();
    for (const Record& record : docs_.all())
      if (record.kind == DocKind::type) add_type(record);
    for (const Record& record : docs_.all()) {
      if (record.kind == DocKind::module) text_ += comment(record.text) + record.name() + " = {}\n\n";
      if (record.kind == DocKind::function || record.kind == DocKind::method) add_function(record);
    }
    return std::move(text_);
  }

 private:
  void add_type(const Record& type) {
    text_ += comment(type.text) + "---@class " + type.name() + "\n";
    if (const Record* element = docs_.element(type.name()))
      text_ += "---@field [integer] " + result_annotations(element->returns_type, {docs_}).front() + "\n";
    for (const Record* member : docs_.members(type.name()))
      if (member->kind == DocKind::property)
        text_ += fmt::format("---@field {} {} {}\n", member->member, type_annotation(member->returns_type, {docs_}),
                             with_unit(member->text, member->returns));
    text_ += "local " + type.name() + " = {}\n\n";
  }

  void add_function(const Record& record) {
    std::string head = comment(record.text);
    if (!record.errors.empty()) head += comment("\nFails on " + record.errors + ".");
    head += comment("\n```lua\n" + example_lines(record.example) + "\n```");
    std::string names;
    for (const ArgumentDoc& argument : record.arguments) {
      const std::string name = identifier(argument.name);
      head += fmt::format("---@param {}{} {} {}\n", name, argument.optional ? "?" : "",
                          annotation(argument, dotted(record.name()) + "." + argument.name),
                          with_unit(argument.text, argument.unit));
      names += (names.empty() ? "" : ", ") + name;
    }
    text_ += head + results(record) + "function " + record.name() + "(" + names + ") end\n\n";
  }

  std::string results(const Record& record) const {
    if (record.returns_type.empty()) return {};
    std::string text;
    for (const std::string& annotation : result_annotations(record.returns_type, {docs_}))
      text += "---@return " + annotation + (text.empty() ? " # " + record.returns : "") + "\n";
    return text;
  }

  static std::string dotted(std::string name) {
    std::replace(name.begin(), name.end(), ':', '.');
    return name;
  }

  /// Of an argument or an option; adds the classes and aliases that it needs.
  template <class Documented>
  std::string annotation(const Documented& doc, const std::string& path) {
    if (doc.type == "function") return function_annotation(doc.text, docs_);
    TypeWords words{docs_};
    if (!doc.values.empty()) words.name = alias(doc.values, doc.name, path);
    if (!doc.options.empty()) words.table = option_class(doc.options, path);
    return doc.type.starts_with('\'') ? words.name : type_annotation(doc.type, words);
  }

  /// The name of a set of texts: "meander.firing_name", or longer where another set is called so.
  std::string alias(const std::vector<std::string>& values, const std::string& name, const std::string& path) {
    std::string either;
    for (const std::string& value : values) either += (either.empty() ? "'" : "|'") + value + "'";
    if (const auto known = aliases_.find(either); known != aliases_.end()) return known->second;
    const std::string shortest = "meander." + name + "_name";
    const bool taken = name == "name" || std::any_of(aliases_.begin(), aliases_.end(),
                                                     [&](const auto& known) { return known.second == shortest; });
    const std::string chosen = taken ? path : shortest;
    text_ += "---@alias " + chosen + " " + either + "\n\n";
    return aliases_[either] = chosen;
  }

  /// The name of the class of a table of options; equal tables share one.
  std::string option_class(const std::vector<OptionDoc>& options, const std::string& path) {
    const auto [known, fresh] = classes_.try_emplace(shape_of(options), path);
    const std::string name = known->second;
    if (!fresh) return name;
    std::string fields;
    for (const OptionDoc& option : options) {
      const std::string note = option.standard.empty() ? "" : "; " + option.standard + " when left out";
      fields += fmt::format("---@field {}{} {} {}\n", option.name, option.required ? "" : "?",
                            annotation(option, path + "." + option.name), with_unit(option.text, option.unit) + note);
    }
    text_ += "---@class " + name + "\n" + fields + "\n";
    return name;
  }

  const Docs& docs_;
  std::string text_;
  std::map<std::string, std::string> classes_;  ///< shape to name
  std::map<std::string, std::string> aliases_;  ///< texts to name
};

}  // namespace

std::string luals_stubs(const Docs& docs) { return Stubs(docs).run(); }

}  // namespace meander::script

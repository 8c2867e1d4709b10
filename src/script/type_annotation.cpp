// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/type_annotation.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace meander::script {
namespace {

using Texts = std::vector<std::string_view>;

/// Words whose annotation is another. A place is given by its name or its handle.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kWords = {{
    {"list of numbers", "number[]|numbers"},
    {"place", "string|thing"},
    {"pattern", "string"},
    {"path", "string"},
    {"file name", "string"},
    {"text", "string"},
    {"table of functions", "table<string, function>"},
    {"{x, y}", "meander.point"},
    {"{x, y, heading}", "meander.pose"},
    {"{{x, y}, {x, y}}", "meander.box"},
    {"{width, height}", "meander.size"},
}};
constexpr std::array<std::string_view, 9> kLuaTypes = {"number", "integer",  "boolean", "string", "any",
                                                       "nil",    "function", "true",    "false"};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Splits at the marks that stand outside of brackets and quotes.
Texts split(std::string_view text, std::initializer_list<std::string_view> marks) {
  Texts parts;
  int depth = 0;
  bool quoted = false;
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') quoted = !quoted;
    depth += text[i] == '{' || text[i] == '(' ? 1 : text[i] == '}' || text[i] == ')' ? -1 : 0;
    if (depth > 0 || quoted) continue;
    for (const std::string_view mark : marks) {
      if (!text.substr(i).starts_with(mark)) continue;
      parts.push_back(trimmed(text.substr(start, i - start)));
      start = i + mark.size();
    }
  }
  parts.push_back(trimmed(text.substr(start)));
  return parts;
}

/// "{v =, w =}" is { v?: any, w?: any }; keys without "=" are numbers that may also be given by their place.
std::string table_annotation(std::string_view inner) {
  std::string fields;
  bool by_place = false;
  for (std::string_view key : split(inner, {","})) {
    const bool named = key.ends_with('=');
    if (named) key = trimmed(key.substr(0, key.size() - 1));
    by_place = by_place || !named;
    fields += (fields.empty() ? "" : ", ") + std::string(key) + (named ? "?: any" : "?: number");
  }
  return "{ " + fields + (by_place ? ", [integer]: number" : "") + " }";
}

std::string element_annotation(std::string_view type, const TypeWords& words) {
  const std::string element = type_annotation(type, words);
  return element.find_first_of("|:") == std::string::npos ? element : "(" + element + ")";
}

std::string word_annotation(std::string_view word, const TypeWords& words) {
  for (const auto& [text, annotation] : kWords)
    if (word == text) return std::string(annotation);
  if (std::find(kLuaTypes.begin(), kLuaTypes.end(), word) != kLuaTypes.end() || word.starts_with('\''))
    return std::string(word);
  if (word == "name") return words.name;
  if (word == "table" || word == "table of options") return words.table;
  if (word.starts_with("function(")) return function_annotation(word, words.docs);
  if (word.starts_with('{') && word.ends_with('}')) return table_annotation(word.substr(1, word.size() - 2));
  if (word.starts_with("table of ")) return "table<string, " + type_annotation(word.substr(9), words) + ">";
  const Record* type = words.docs.find(word);
  return type && type->kind == DocKind::type ? type->name() : "unknown";
}

}  // namespace

std::string type_annotation(std::string_view type, const TypeWords& words) {
  std::string all;
  for (Texts rest = split(type, {", ", " or ", " | "}); !rest.empty(); rest.erase(rest.begin())) {
    const std::string before = all;
    if (!all.empty()) all += "|";
    const std::string_view part = rest.front();
    if (!part.starts_with("list of ") || part == "list of numbers") {
      all += word_annotation(part, words);
    } else if (part == "list of these") {
      all += "(" + before + ")[]";
    } else {
      // A list is one of all that follows.
      return all + element_annotation(type.substr(static_cast<std::size_t>(part.data() - type.data()) + 8), words) +
             "[]";
    }
  }
  return all;
}

std::vector<std::string> result_annotations(std::string_view type, const TypeWords& words) {
  const Texts parts = split(type, {", "});
  const bool one = std::any_of(parts.begin(), parts.end(), [](std::string_view part) {
    const Texts either = split(part, {" or "});
    return either.size() > 1 && either.back() != "nil";
  });
  std::vector<std::string> annotations;
  if (one) return {type_annotation(type, words)};
  for (const std::string_view part : parts) annotations.push_back(type_annotation(part, words));
  return annotations;
}

std::string function_annotation(std::string_view text, const Docs& docs) {
  if (!text.starts_with("function(")) return "function";
  const std::size_t close = text.find(')');
  std::string arguments;
  for (const std::string_view name : split(text.substr(9, close - 9), {","})) {
    const Record* type = docs.find(name);
    const bool known = type && type->kind == DocKind::type;
    const std::string argument(name == "function" || name == "end" ? "value" : name);
    if (!name.empty()) arguments += (arguments.empty() ? "" : ", ") + argument + ": " + (known ? argument : "any");
  }
  return "fun(" + arguments + "): ...any";
}

std::string point_classes() {
  return R"(---A point; results have [1], [2] and x, y, arguments may have either.
---@class meander.point
---@field x? number [m]
---@field y? number [m]
---@field [integer] number

---A pose; as a point, with [3] or heading.
---@class meander.pose: meander.point
---@field heading? number [rad]

---Lower left and upper right corner.
---@alias meander.box meander.point[]

---@class meander.size
---@field width? number [m]
---@field height? number [m]
---@field [integer] number

)";
}

}  // namespace meander::script

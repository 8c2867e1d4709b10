// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/toml_table.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/names.hpp"
#include "world/text.hpp"

namespace meander {

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("text '{}'", printable(text->get()));
  if (const auto* number = node.as_integer()) return fmt::format("number {}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("number {}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_table()) return "a table";
  const auto* list = node.as_array();
  if (!list) return "a date or time";
  const bool numbers = std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_number(); });
  if (!numbers) return fmt::format("a list of {}", list->size());
  return fmt::format("{} number{}", list->size(), list->size() == 1 ? "" : "s");
}

TomlTable::TomlTable(const toml::table& table, std::string path, std::string title)
    : table_(table), path_(std::move(path)), title_(std::move(title)) {}

void TomlTable::refuse_plainly(const std::string& message) const {
  fail<FileError>("{}:{}: {}", path_, table_.source().begin.line, message);
}

void TomlTable::refuse(const std::string& message, const char* key) const {
  const toml::node* at = key ? table_.get(key) : nullptr;
  fail<FileError>("{}:{}: {}: {}", path_, (at ? at->source() : table_.source()).begin.line, title_, message);
}

void TomlTable::refuse_value(const char* key, const char* expected, const toml::node& got) const {
  const auto line = (got.source().begin ? got.source() : table_.source()).begin.line;
  fail<FileError>("{}:{}: {}: key '{}': {} expected, got {}", path_, line, title_, key, expected, describe(got));
}

void TomlTable::check_keys(const std::vector<std::string>& known) const {
  for (const auto& [key, value] : table_) {
    const std::string name(key.str());
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    fail<FileError>("{}:{}: {}{}unknown key '{}'{} (known: {})", path_, key.source().begin.line, title_,
                    title_.empty() ? "" : ": ", printable(name), did_you_mean(name, known),
                    listing(known, known.size()));
  }
}

const toml::node& TomlTable::node(const char* key) const {
  const toml::node* found = table_.get(key);
  if (!found) refuse(fmt::format("key '{}' is missing", key));
  return *found;
}

double TomlTable::number(const char* key) const {
  const auto value = node(key).value<double>();
  if (!value || !node(key).is_number()) refuse_value(key, "number", node(key));
  return *value;
}

std::optional<double> TomlTable::optional_number(const char* key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

bool TomlTable::flag(const char* key, bool usual) const {
  if (!has(key)) return usual;
  const auto* value = node(key).as_boolean();
  if (!value) refuse_value(key, "true or false", node(key));
  return value->get();
}

std::string TomlTable::text(const char* key, const std::string& usual) const {
  if (!has(key)) return usual;
  const auto* value = node(key).as_string();
  if (!value) refuse_value(key, "text in quotes", node(key));
  return value->get();
}

std::int64_t TomlTable::integer(const char* key) const {
  const auto* value = node(key).as_integer();
  if (!value) refuse_value(key, "whole number", node(key));
  return value->get();
}

std::vector<double> TomlTable::numbers(const char* key, const toml::node& list, std::size_t count,
                                       const char* form) const {
  const auto* array = list.as_array();
  std::vector<double> values;
  if (array && array->size() == count)
    for (const toml::node& element : *array)
      if (element.is_number()) values.push_back(*element.value<double>());
  if (values.size() != count) refuse_value(key, form, list);
  return values;
}

Vec2 TomlTable::pair(const char* key, const char* form) const {
  const std::vector<double> v = numbers(key, node(key), 2, form);
  return {v[0], v[1]};
}

Pose2 TomlTable::pose(const char* key) const {
  const std::vector<double> v = numbers(key, node(key), 3, "[x, y, heading]");
  return {v[0], v[1], v[2]};
}

std::vector<Vec2> TomlTable::points(const char* key, const toml::node& list) const {
  const auto* array = list.as_array();
  if (!array) refuse_value(key, "list of points [x, y]", list);
  std::vector<Vec2> result;
  result.reserve(array->size());
  for (const toml::node& element : *array) {
    const std::vector<double> v = numbers(key, element, 2, "points [x, y]");
    result.emplace_back(v[0], v[1]);
  }
  return result;
}

std::vector<Vec2> TomlTable::points(const char* key) const { return points(key, node(key)); }

std::vector<std::vector<Vec2>> TomlTable::point_lists(const char* key) const {
  if (!has(key)) return {};
  const auto* array = node(key).as_array();
  if (!array) refuse_value(key, "list of lists of points", node(key));
  std::vector<std::vector<Vec2>> result;
  for (const toml::node& element : *array) result.push_back(points(key, element));
  return result;
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.hpp"

namespace meander {

/// Reads the keys of one TOML table. Whatever is wrong becomes a FileError
/// "path:line: [[obstacle]] 'crate': key 'size': [width, height] expected, got 3 numbers".
class TomlTable {
 public:
  /// `title` names the table in messages: "[[obstacle]] 'crate'". The table must outlive the reader.
  TomlTable(const toml::table& table, std::string path, std::string title);

  /// Refuses keys that are not among the known ones, with the nearest of them.
  void check_keys(const std::vector<std::string>& known) const;
  bool has(const char* key) const { return table_.contains(key); }

  // Required, or with the value that holds when the key is missing.
  double number(const char* key) const;
  double number(const char* key, double usual) const { return has(key) ? number(key) : usual; }
  std::optional<double> optional_number(const char* key) const;
  bool flag(const char* key, bool usual) const;
  std::string text(const char* key, const std::string& usual) const;
  std::int64_t integer(const char* key) const;
  /// `form` says in messages what the numbers mean: "[x, y]".
  Vec2 pair(const char* key, const char* form = "[x, y]") const;
  Pose2 pose(const char* key) const;
  std::vector<Vec2> points(const char* key) const;
  std::vector<std::vector<Vec2>> point_lists(const char* key) const;

  /// Throws "path:line: title: message" at the line of the key, or of the table.
  [[noreturn]] void refuse(const std::string& message, const char* key = nullptr) const;
  /// The same without the title, for a message that names the thing itself.
  [[noreturn]] void refuse_plainly(const std::string& message) const;

 private:
  const toml::node& node(const char* key) const;
  [[noreturn]] void refuse_value(const char* key, const char* expected, const toml::node& got) const;
  std::vector<double> numbers(const char* key, const toml::node& list, std::size_t count, const char* form) const;
  std::vector<Vec2> points(const char* key, const toml::node& list) const;

  const toml::table& table_;
  std::string path_;
  std::string title_;
};

/// "number 3", "text 'abc'", "3 numbers", "a table": what a value is, for messages.
std::string describe(const toml::node& node);

}  // namespace meander

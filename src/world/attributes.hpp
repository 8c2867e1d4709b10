// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "base/hash.hpp"
#include "world/edit.hpp"

namespace meander {

using Points = std::vector<Vec2>;

/// One key of a thing with its value, under the names that files and scripts use.
struct Attribute {
  using Value = std::variant<bool, double, std::string, Vec2, Pose2, Points, std::vector<Points>>;
  const char* key;
  Value value;
  bool usual = false;  ///< the value holds anyway when it is left out
  bool operator==(const Attribute& other) const { return std::string(key) == other.key && value == other.value; }
};
using Attributes = std::vector<Attribute>;

/// The one listing of everything that makes up a thing: files, scripts, differences and hashes come from it. The first
/// is its name. Optional values that are not there are not listed.
Attributes attributes(const Item& item);
Attributes attributes(const Header& header);

void add_to(Hash& hash, const Attributes& attributes);

/// How a language writes lists and texts.
struct Dialect {
  char open, close;
  std::string (*quoted)(const std::string&);
};
extern const Dialect kToml;
extern const Dialect kLua;

/// Numbers are the shortest that read back to the same bits. Long lists of points are broken into lines.
std::string value_text(const Attribute::Value& value, const Dialect& dialect);

}  // namespace meander

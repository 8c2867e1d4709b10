// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace meander {

/// One key of a flat YAML file.
struct YamlEntry {
  std::string key;
  int line = 0;
  bool list = false;
  std::vector<std::string> values;  ///< one when it is no list
};

/// Reads the part of YAML that map files use: "key: value" from the first column on, lists as [a, b] or as lines "- a",
/// quotes, comments. Throws FileError "name:line: ..." for anything else, and for a key that comes twice.
std::vector<YamlEntry> flat_yaml(std::string_view text, const std::string& name);

/// The text as a value that flat_yaml() and every other reader of YAML gives back as it was.
std::string yaml_scalar(const std::string& text);

}  // namespace meander

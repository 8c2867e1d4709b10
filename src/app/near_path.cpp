// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/near_path.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/names.hpp"

namespace meander {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error))
    names.push_back(entry->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<fs::path> nearest_existing(const fs::path& path) {
  fs::path reached;
  std::error_code error;
  for (const fs::path& part : path) {
    if (fs::exists(reached / part, error)) {
      reached /= part;
    } else if (fs::exists(reached / (part.string() + ".lua"), error)) {
      reached /= part.string() + ".lua";
    } else if (const auto name = nearest_name(part.string(), names_in(reached))) {
      reached /= *name;
    } else {
      return std::nullopt;
    }
  }
  return reached;
}

}  // namespace

std::string near_path_hint(const std::string& path) {
  const auto near = nearest_existing(path);
  return near ? "; did you mean '" + near->string() + "'?" : std::string();
}

}  // namespace meander

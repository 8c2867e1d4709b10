// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/near_path.hpp"

#include <algorithm>
#include <filesystem>
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

}  // namespace

std::optional<std::string> near_path(const std::string& path, const std::string& folder) {
  const fs::path base(folder);
  fs::path reached;
  std::error_code error;
  for (const fs::path& part : fs::path(path)) {
    if (fs::exists(base / reached / part, error)) {
      reached /= part;
    } else if (fs::exists(base / reached / (part.string() + ".lua"), error)) {
      reached /= part.string() + ".lua";
    } else if (const auto name = nearest_name(part.string(), names_in(base / reached))) {
      reached /= *name;
    } else {
      return std::nullopt;
    }
  }
  return reached.empty() ? std::nullopt : std::optional(reached.string());
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/test_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/data_folder.hpp"
#include "base/error.hpp"

namespace meander {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kSuffix = "_test.lua";

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code unreadable;
    if (name.starts_with('.'))
      entry.disable_recursion_pending();
    else if (name.ends_with(kSuffix) && entry->is_regular_file(unreadable))
      files.push_back(entry->path().lexically_normal().string());
  }
  if (error) fail<FileError>("cannot read folder '{}': {}", folder.string(), error.message());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> test_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  std::set<std::string> known;
  const auto add = [&](const std::string& file) {
    if (known.insert(file).second) files.push_back(file);
  };
  for (const std::string& wanted : paths) {
    std::error_code error;
    const auto found = find_file(wanted);
    if (!found) fail<FileError>("no file or folder '{}'{}", wanted, missing_file_hint(wanted));
    const std::string& path = *found;
    if (fs::is_directory(path, error)) {
      for (const std::string& file : files_below(path)) add(file);
    } else {
      add(fs::path(path).lexically_normal().string());
    }
  }
  return files;
}

void check_inside(const std::vector<std::string>& paths, const std::string& folder) {
  std::error_code failed;
  const auto leads_into = [&](const fs::path& path, const fs::path& place) {
    const fs::path way = fs::canonical(path, failed).lexically_relative(fs::canonical(place, failed));
    return !way.empty() && *way.begin() != "..";
  };
  if (!fs::is_directory(folder, failed)) fail<FileError>("sandbox: no folder '{}' (--sandbox-folder)", folder);
  for (const std::string& wanted : paths) {
    const std::string path = find_file(wanted).value_or(wanted);
    if (!leads_into(path, folder) && !leads_into(path, data_folder()))
      fail<FileError>("sandbox: '{}' is not in the folder that may be used (--sandbox-folder)", wanted);
  }
}

}  // namespace meander

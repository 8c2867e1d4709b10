// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/data_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/error.hpp"
#include "base/near_path.hpp"

namespace meander {
namespace fs = std::filesystem;
namespace {

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// The same name in the data folder; nothing where the name cannot be one of there.
std::optional<std::string> in_data_folder(const std::string& path) {
  const fs::path name = fs::path(path).lexically_normal();
  const std::string folder = data_folder();
  if (folder.empty() || name.empty() || name.is_absolute() || *name.begin() == "..") return std::nullopt;
  return (fs::path(folder) / name).string();
}

}  // namespace

std::vector<std::string> beside_program(const std::string& name) {
  std::error_code failed;
  fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  std::vector<std::string> paths;
  for (int level = 0; level < 3 && !folder.empty(); ++level, folder = folder.parent_path())
    paths.push_back((folder / name).string());
  return paths;
}

std::string data_folder() {
  if (const char* folder = std::getenv("MEANDER_DATA_DIR"); folder && *folder) return folder;
  for (const std::string& path : beside_program("share/meander"))
    if (std::error_code ignored; fs::exists(path, ignored)) return fs::canonical(path, ignored).string();
  return {};
}

std::optional<std::string> find_file(const std::string& path) {
  if (exists(path)) return path;
  auto found = in_data_folder(path);
  return found && exists(*found) ? found : std::nullopt;
}

std::string missing_file_hint(const std::string& path) {
  auto near = near_path(path);
  const bool elsewhere = in_data_folder(path).has_value();
  if (!near && elsewhere) near = near_path(path, data_folder());
  if (near) return fmt::format("; did you mean '{}'?", *near);
  return elsewhere ? ", here or in " + data_folder() : std::string();
}

std::string readable_file(const std::string& path) {
  if (auto found = find_file(path)) return *found;
  fail<FileError>("{}: no such file{}", path, missing_file_hint(path));
}

std::vector<std::string> data_files(const std::string& start) {
  const auto place = in_data_folder(start.empty() || start.ends_with('/') ? start + "." : start);
  if (!place) return {};
  const std::string parent = start.substr(0, start.rfind('/') + 1);
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator entry(fs::path(*place).parent_path(), failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string name = parent + entry->path().filename().string();
    if (name.starts_with(start)) names.push_back(entry->is_directory(failed) ? name + "/" : name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace meander

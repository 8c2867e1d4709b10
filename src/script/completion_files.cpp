// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/data_folder.hpp"

namespace meander::script {
namespace {

namespace fs = std::filesystem;

/// With its slash.
std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

/// As data_files(), but those of the working folder.
std::vector<std::string> files_here(const std::string& start) {
  const std::string parent = folder_of(start);
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator entry(parent.empty() ? "." : parent, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    names.push_back(parent + name + (entry->is_directory(unknown) ? "/" : ""));
  }
  return names;
}

}  // namespace

std::vector<std::string> suffixes_in(std::string_view text) {
  const auto in_suffix = [](unsigned char c) { return std::isalnum(c) != 0; };
  std::vector<std::string> suffixes;
  for (std::size_t dot = text.find('.'); dot != std::string_view::npos; dot = text.find('.', dot + 1)) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(dot);
    const auto end = std::find_if_not(begin + 1, text.end(), in_suffix);
    if (end - begin > 1) suffixes.emplace_back(begin, end);
  }
  return suffixes;
}

std::vector<std::string> files_with(const std::vector<std::string>& suffixes, const std::string& start) {
  std::vector<std::string> names = files_here(start);
  for (std::string& name : data_files(start)) names.push_back(std::move(name));
  const std::size_t begin = folder_of(start).size();
  const bool hidden_too = start.substr(begin).starts_with('.');
  std::erase_if(names, [&](const std::string& name) {
    if (!hidden_too && name.substr(begin).starts_with('.')) return true;
    const auto ends = [&](const std::string& suffix) { return name.ends_with(suffix); };
    return !name.ends_with('/') && std::none_of(suffixes.begin(), suffixes.end(), ends);
  });
  return names;
}

}  // namespace meander::script

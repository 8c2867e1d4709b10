// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "base/error.hpp"
#include "base/names.hpp"

namespace meander {

namespace fs = std::filesystem;

std::string nearest_file(const std::string& path) {
  const fs::path wanted(path);
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    names.push_back(entry->path().filename().string());
  std::sort(names.begin(), names.end());
  const auto nearest = nearest_name(wanted.filename().string(), names);
  if (!nearest) return {};
  return fmt::format("; did you mean '{}'?", (wanted.parent_path() / *nearest).string());
}

std::string read_text_file(const std::string& path, std::size_t most) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (status.type() == fs::file_type::not_found) fail<FileError>("{}: no such file{}", path, nearest_file(path));
  if (fs::is_directory(status)) fail<FileError>("{}: is a folder", path);
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  if (!file) fail<FileError>("{}: cannot be read: {}", path, std::generic_category().message(errno));
  std::string text;
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    if (text.size() + count > most) fail<FileError>("{}: larger than the allowed {} MB", path, most >> 20);
    text.append(block, count);
  }
  if (std::ferror(file.get())) fail<FileError>("{}: cannot be read: {}", path, std::generic_category().message(errno));
  return text;
}

}  // namespace meander

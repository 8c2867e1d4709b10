// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "base/error.hpp"
#include "base/near_path.hpp"

namespace meander {

namespace fs = std::filesystem;

std::string read_text_file(const std::string& path, std::size_t most) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (status.type() == fs::file_type::not_found) {
    const auto near = near_path(path);
    fail<FileError>("{}: no such file{}", path, near ? fmt::format("; did you mean '{}'?", *near) : "");
  }
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

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/folder.hpp"

#include <filesystem>

#include "base/error.hpp"

namespace meander {

void make_folder(const std::string& path) {
  std::error_code problem;
  std::filesystem::create_directories(path, problem);
  if (!problem && !std::filesystem::is_directory(path, problem)) problem = std::make_error_code(std::errc::file_exists);
  if (problem) fail<FileError>("{}: cannot be made: {}", path.empty() ? "''" : path, problem.message());
}

}  // namespace meander

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "grid/image_file.hpp"
#include "own_folder.hpp"

namespace meander {

inline std::string scratch(const std::string& name) { return (own_folder() / name).string(); }

inline std::string written(const std::string& name, const std::string& text) {
  std::ofstream(scratch(name), std::ios::binary) << text;
  return scratch(name);
}

inline std::string message(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

inline bool mentions(const std::vector<std::string>& report, const std::string& words) {
  for (const std::string& line : report)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

/// One row of pixels.
inline Image strip(const std::vector<std::uint8_t>& greys) { return {static_cast<int>(greys.size()), 1, 1, greys}; }

}  // namespace meander

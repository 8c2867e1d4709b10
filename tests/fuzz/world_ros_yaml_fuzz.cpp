// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any text is a map file or a FileError.
#include "base/error.hpp"
#include "world/import_ros_map.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    meander::ros_map_file(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
  } catch (const meander::FileError&) {
  }
  return 0;
}

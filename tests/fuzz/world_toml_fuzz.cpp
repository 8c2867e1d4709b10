// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any bytes as a world file: read, or refused with a FileError of one line. What is read survives writing and reading.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/error.hpp"
#include "world/world_file.hpp"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  meander::World world;
  try {
    world = meander::world_from_toml(text, "fuzz.toml");
  } catch (const meander::FileError& error) {
    const std::string message = error.what();
    require(message.starts_with("fuzz.toml:"));
    require(message.find('\n') == std::string::npos);
    return 0;
  }
  const std::string written = to_toml(world);
  const meander::World again = meander::world_from_toml(written, "written.toml");
  require(again == world);
  require(to_toml(again) == written);
  return 0;
}

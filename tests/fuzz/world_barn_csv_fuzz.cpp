// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any text is a world, or an Error that says why not.
#include "base/error.hpp"
#include "world/import_barn.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    meander::barn_from_csv(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
  } catch (const meander::Error&) {
  }
  return 0;
}

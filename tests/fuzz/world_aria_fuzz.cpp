// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any text is a line map, or an Error that says why not.
#include "base/error.hpp"
#include "world/import_aria.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    meander::aria_from_text(text, "fuzz");
  } catch (const meander::Error&) {
  }
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any text is a map and a list of scenarios, or an Error that says why not.
#include "base/error.hpp"
#include "grid/movingai.hpp"
#include "world/import_movingai.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    meander::movingai_from_text(text, "fuzz");
  } catch (const meander::Error&) {
  }
  try {
    meander::movingai_scenarios(text, "fuzz", 4, 3);
  } catch (const meander::Error&) {
  }
  return 0;
}

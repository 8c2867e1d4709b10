// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any text is a log of either kind, or an Error that says why not.
#include "base/error.hpp"
#include "study/sonar_log.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const auto read : {meander::sonar_log_from_csv, meander::sonar_log_from_carmen}) {
    try {
      read(text, "fuzz", {}, {});
    } catch (const meander::Error&) {
    }
  }
  return 0;
}
